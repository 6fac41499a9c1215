import { Agent, request as requestHttp, type IncomingMessage } from 'node:http';
import type { Socket } from 'node:net';
import type { Duplex } from 'node:stream';
import {
  decode,
  encode,
  type AccessRole,
  type Client,
  type Init,
  type ServiceReply,
  type ServiceRequest,
} from '@ubii/proto';
import { WebSocket } from 'ws';

const ANSWER_TIMEOUT_MS = 120_000;

export interface Answer {
  /** 0: there was none. */
  readonly status: number;
  readonly body: Buffer;
}

/** Address of the master, as reached from a place in the network. */
export interface Place {
  readonly host: string;
  readonly port: number;
  /** The own address. */
  readonly from: string;
  /** Header of every request. */
  readonly headers: Readonly<Record<string, string>>;
  dial(): Promise<Socket>;
}

/** A client that joined. */
export interface Member {
  readonly client: Client;
  readonly bearer: string | undefined;
}

/** Somebody with an address, with or without an invitation. */
export class Outsider {
  readonly place: Place;
  readonly #agent: DialingAgent;

  constructor(place: Place) {
    this.place = place;
    this.#agent = new DialingAgent(() => place.dial());
  }

  /** A connection, to write whatever to it. */
  dial(): Promise<Socket> {
    return this.place.dial();
  }

  /** Lines of the head of a request, up to and with the empty line. */
  head(start: string, headers: Readonly<Record<string, string>> = {}): string {
    const all = { Host: this.#host, ...this.place.headers, ...headers };
    const lines = Object.entries(all).map(([name, value]) => `${name}: ${value}`);
    return `${[start, ...lines].join('\r\n')}\r\n\r\n`;
  }

  /** Asks; whoever hangs up has answered with status 0. */
  ask(
    method: string,
    path: string,
    headers: Readonly<Record<string, string>> = {},
    body?: Uint8Array | string,
  ): Promise<Answer> {
    return new Promise((resolve) => {
      const outgoing = requestHttp({
        method,
        path,
        agent: this.#agent,
        host: this.place.host,
        port: this.place.port,
        headers: {
          host: this.#host,
          ...this.place.headers,
          ...(body !== undefined && { 'content-length': String(Buffer.byteLength(body)) }),
          ...headers,
        },
      });
      const fail = (): void => resolve({ status: 0, body: Buffer.alloc(0) });
      outgoing.on('response', (response: IncomingMessage) => {
        const chunks: Buffer[] = [];
        response.on('data', (chunk: Buffer) => chunks.push(chunk));
        const done = (): void =>
          resolve({ status: response.statusCode ?? 0, body: Buffer.concat(chunks) });
        response.on('end', done);
        response.on('error', done);
        response.on('aborted', done);
      });
      outgoing.on('error', fail);
      outgoing.setTimeout(ANSWER_TIMEOUT_MS, () => outgoing.destroy());
      outgoing.end(body);
    });
  }

  /** Calls a service; an error is a reply as well. @throws Error when there is no reply */
  async call(request: Init<ServiceRequest>, bearer?: string): Promise<ServiceReply> {
    const { status, body } = await this.ask(
      'POST',
      '/services/binary',
      {
        'content-type': 'application/octet-stream',
        ...(bearer !== undefined && { authorization: `Bearer ${bearer}` }),
      },
      encode('ubii.services.ServiceRequest', request),
    );
    if (status !== 200) throw new Error(`${request.topic} was answered with status ${status}`);
    return decode('ubii.services.ServiceReply', new Uint8Array(body));
  }

  /** The role of the caller. */
  async role(bearer?: string): Promise<AccessRole> {
    const { joinCheck, error } = await this.call(
      { topic: '/services/ubii/join_check', joinCheckRequest: {} },
      bearer,
    );
    if (joinCheck === undefined) throw new Error(error?.message);
    return joinCheck.role;
  }

  /** Registers with a token or code. @throws Error when it is refused */
  async join(bearer: string | undefined, client: Init<Client> = {}): Promise<Member> {
    const reply = await this.call(
      {
        topic: '/services/client/registration',
        client: { name: 'guest', ...client, extension: { recordLists: true, ...client.extension } },
      },
      bearer,
    );
    if (reply.client === undefined) throw new Error(reply.error?.message ?? 'not registered');
    return { client: reply.client, bearer: reply.client.extension?.credential || bearer };
  }

  /** Opens the socket of topic data. @throws Error when it is refused */
  openSocket({ client }: Member): Promise<WebSocket> {
    const token = client.extension?.resumeToken ?? '';
    const { host, port, headers } = this.place;
    const name = host.includes(':') ? `[${host}]` : host;
    const socket = new WebSocket(`ws://${name}:${port}/?clientID=${client.id}&token=${token}`, {
      headers: { ...headers },
      agent: this.#agent,
      perMessageDeflate: false,
    });
    // A client without activity is removed after a while. [CL-10]
    socket.on('message', (data, isBinary) => {
      if (!isBinary && String(data as Buffer) === 'PING') socket.send('PONG');
    });
    return new Promise((resolve, reject) => {
      socket.once('open', () => resolve(socket));
      socket.once('error', reject);
      socket.on('error', () => {});
    });
  }

  get #host(): string {
    const { host, port } = this.place;
    return host.includes(':') ? `[${host}]:${port}` : `${host}:${port}`;
  }
}

/** An agent whose connections begin elsewhere. */
class DialingAgent extends Agent {
  readonly #dial: () => Promise<Socket>;

  constructor(dial: () => Promise<Socket>) {
    super({ keepAlive: false });
    this.#dial = dial;
  }

  override createConnection(
    _options: object,
    callback?: (error: Error | null, stream: Duplex) => void,
  ): Duplex {
    this.#dial().then(
      (socket) => callback?.(null, socket),
      (error: unknown) => callback?.(error as Error, undefined as unknown as Duplex),
    );
    // Node waits for the callback when there is no socket yet.
    return undefined as unknown as Duplex;
  }
}
