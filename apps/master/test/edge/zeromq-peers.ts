import { once } from 'node:events';
import { connect, type Socket } from 'node:net';
import { decode, decodeTopicData, encode, type Init, type ServiceRequest } from '@ubii/proto';
import { onTestFinished } from 'vitest';
import { Dealer, Request } from 'zeromq';

import { OPENING, REST_OF_GREETING, encodeReady } from '../../src/adapters/zeromq/greeting.ts';
import type { EdgeMaster } from './edge-master.ts';

/** The ports of ZeroMQ of a master that has them. */
export function zeromqPorts({ ports }: EdgeMaster): { services: number; topicData: number } {
  if (ports.zeromq === undefined) throw new Error('The master has no ports of ZeroMQ.');
  return ports.zeromq;
}

export type Reply = ReturnType<typeof decode<'ubii.services.ServiceReply'>>;

/** Services as existing clients call them over ZeroMQ: a REQ, one request at a time. */
export class ZeroMqCaller {
  readonly #request = new Request({ linger: 0 });

  constructor(master: EdgeMaster) {
    this.#request.connect(`tcp://127.0.0.1:${zeromqPorts(master).services}`);
    onTestFinished(() => this.#request.close());
  }

  async call(request: Init<ServiceRequest>): Promise<Reply> {
    return decode(
      'ubii.services.ServiceReply',
      await this.send(encode('ubii.services.ServiceRequest', request)),
    );
  }

  async send(request: Uint8Array | string): Promise<Buffer> {
    await this.#request.send(Buffer.from(request));
    const frames = await this.#request.receive();
    if (frames.length !== 1) throw new Error(`A reply is one frame, not ${frames.length}.`);
    return frames[0]!;
  }

  async register(name = 'tester'): Promise<string> {
    const { client, error } = await this.call({
      topic: '/services/client/registration',
      client: { name },
    });
    if (client === undefined) throw new Error(error?.message);
    return client.id;
  }

  subscribe(clientId: string, ...subscribeTopics: string[]): Promise<Reply> {
    return this.call({
      topic: '/services/topic_subscription',
      topicSubscription: { clientId, subscribeTopics },
    });
  }
}

/** Topic data as existing clients have it over ZeroMQ: a DEALER whose identity is the id of the client. */
export class ZeroMqClient {
  readonly dealer: Dealer;
  /** The connection ended. */
  readonly ended: Promise<void>;
  #connections = 0;

  constructor(master: EdgeMaster, clientId: string) {
    this.dealer = new Dealer({ routingId: clientId, linger: 0 });
    this.ended = new Promise((resolve) => this.dealer.events.on('disconnect', () => resolve()));
    this.dealer.events.on('connect', () => this.#connections++);
    this.dealer.connect(`tcp://127.0.0.1:${zeromqPorts(master).topicData}`);
    onTestFinished(() => this.dealer.close());
  }

  /** How often the library connected. */
  get connections(): number {
    return this.#connections;
  }

  /** The next message that is no PING, without its delimiter. */
  async next(): Promise<Buffer> {
    for (;;) {
      const [delimiter, content, ...rest] = await this.dealer.receive();
      if (delimiter?.length !== 0 || content === undefined || rest.length > 0) {
        throw new Error('A message is an empty frame and one more.'); // pitfall 15
      }
      if (content.toString() !== 'PING') return content;
      await this.dealer.send('PONG');
    }
  }

  async nextTopicData() {
    return decodeTopicData(await this.next());
  }
}

/** A program that writes what it likes to a port. */
export class RawPeer {
  readonly socket: Socket;
  readonly ended: Promise<unknown>;
  #read = Buffer.alloc(0);
  #wake = (): void => undefined;

  constructor(port: number) {
    this.socket = connect(port, '127.0.0.1');
    this.socket.on('error', () => undefined);
    this.ended = once(this.socket, 'close');
    this.socket.on('data', (chunk: Buffer) => {
      this.#read = Buffer.concat([this.#read, chunk]);
      this.#wake();
    });
    onTestFinished(() => void this.socket.destroy());
  }

  /** Greets as ZMTP 3.1 does, without an identity. */
  static async greeted(port: number, type: 'REQ' | 'DEALER'): Promise<RawPeer> {
    const peer = new RawPeer(port);
    peer.write(OPENING, REST_OF_GREETING, encodeReady(type));
    await peer.take(OPENING.length + REST_OF_GREETING.length);
    const [, size = 0] = await peer.take(2);
    await peer.take(size);
    return peer;
  }

  write(...pieces: (Uint8Array | string)[]): void {
    this.socket.write(Buffer.concat(pieces.map((piece) => Buffer.from(piece))));
  }

  async take(size: number): Promise<Buffer> {
    while (this.#read.length < size) await new Promise<void>((resolve) => (this.#wake = resolve));
    const taken = this.#read.subarray(0, size);
    this.#read = this.#read.subarray(size);
    return taken;
  }

  /** Takes a frame: its flags and its body. */
  async takeFrame(): Promise<{ flags: number; body: Buffer }> {
    const [flags = 0] = await this.take(1);
    const size =
      (flags & 2) === 0 ? (await this.take(1))[0]! : Number((await this.take(8)).readBigUInt64BE());
    return { flags, body: await this.take(size) };
  }
}
