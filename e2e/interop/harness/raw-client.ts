import { WebSocket } from 'ws';
import { EventLog } from './event-log.ts';
import type { LegacyAddresses } from './legacy-client.ts';
import type { OldSchema } from './old-schema.ts';

/** A frame of the topic-data channel, decoded with the published message formats. */
export type RawFrame =
  | { readonly text: string }
  | { readonly message: Readonly<Record<string, unknown>> };

/**
 * Speaks the protocol by hand, for clients that cannot be installed here: what they send is written
 * down in the tests, and read with the published message formats.
 */
export class RawClient {
  readonly frames = new EventLog<RawFrame>();
  readonly #addresses: LegacyAddresses;
  readonly #schema: OldSchema;
  #socket: WebSocket | undefined;

  constructor(addresses: LegacyAddresses, schema: OldSchema) {
    this.#addresses = addresses;
    this.#schema = schema;
  }

  /** A service call in JSON, as browsers make it. */
  async callJson(request: object, path = '/services/json'): Promise<Record<string, unknown>> {
    const response = await fetch(new URL(path, this.#addresses.services), {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify(request),
    });
    if (!response.ok) throw new Error(`HTTP ${response.status}: ${await response.text()}`);
    return (await response.json()) as Record<string, unknown>;
  }

  /** A service call in protobuf, as the Unity node makes it. */
  async callBinary(request: object, path = '/services/binary'): Promise<Record<string, unknown>> {
    const response = await fetch(new URL(path, this.#addresses.services), {
      method: 'POST',
      headers: { 'content-type': 'application/octet-stream' },
      body: new Uint8Array(this.#schema.request.createBufferFromPayload(request)),
    });
    if (!response.ok) throw new Error(`HTTP ${response.status}: ${await response.text()}`);
    return this.#schema.reply.createPayloadFromBuffer(new Uint8Array(await response.arrayBuffer()));
  }

  /** Opens the socket. @param pong what is answered to a ping, and how */
  async open(clientId: string, path = '', pong: string | Buffer = 'PONG'): Promise<void> {
    const socket = new WebSocket(`${this.#addresses.topicData}${path}?clientID=${clientId}`);
    this.#socket = socket;
    socket.on('message', (data: Buffer, isBinary) => {
      if (isBinary) {
        const message = this.#schema.topicData.createPayloadFromBuffer(new Uint8Array(data));
        this.frames.add({ message });
        return;
      }
      const text = data.toString();
      if (text === 'PING') socket.send(pong);
      this.frames.add({ text });
    });
    await new Promise<void>((resolve, reject) => {
      socket.once('open', resolve);
      socket.once('error', reject);
    });
  }

  publish(record: object): void {
    this.#socket!.send(this.#schema.topicData.createBufferFromPayload({ topicDataRecord: record }));
  }

  /** The next record on a topic, now or later. */
  async receives(topic: string): Promise<Record<string, unknown>> {
    const frame = await this.frames.waitFor(
      `a record on ${topic}`,
      (candidate) => recordIn(candidate)?.['topic'] === topic,
    );
    return recordIn(frame)!;
  }

  close(): void {
    this.#socket?.terminate();
  }
}

function recordIn(frame: RawFrame): Record<string, unknown> | undefined {
  if ('text' in frame) return undefined;
  return frame.message['topicDataRecord'] as Record<string, unknown> | undefined;
}
