import { afterEach, describe, expect, it } from 'vitest';
import type {
  TopicDataHandler,
  TopicDataQuery,
  TopicDataTransport,
} from '../core/ports/topic-data-transport.ts';

/** The master's end of a socket the transport opened. */
export interface ServerSocket {
  readonly query: TopicDataQuery;
  sendBinary(bytes: Uint8Array): void;
  sendText(text: string): void;
  close(code: number, reason: string): void;
  /** Breaks the link without a close handshake. */
  cut(): void;
}

/** Events at the master, in order. */
export interface ServerEvents {
  handleOpen(socket: ServerSocket): void;
  handleBinary(bytes: Uint8Array): void;
  handleText(text: string): void;
  handleClose(): void;
}

/** A transport with a master behind it that does what the suite says. */
export interface TopicDataTransportWorld {
  readonly transport: TopicDataTransport;
  /** Makes the master unreachable and frees what the world holds. */
  close(): Promise<void>;
}

const ADA: TopicDataQuery = {
  clientId: 'ada-1',
  resumeToken: 'a+b/c=&d',
  sentMs: 1_700_000_000_123,
};

/**
 * Acceptance tests of topic-data transports. An adapter's test passes a function that sets up the adapter and a master
 * at its other end.
 */
export function describeTopicDataTransport(
  name: string,
  setup: (events: ServerEvents) => Promise<TopicDataTransportWorld>,
): void {
  describe(`${name} as a topic-data transport`, () => {
    let world: TopicDataTransportWorld | undefined;
    afterEach(async () => {
      await world?.close();
      world = undefined;
    });

    async function open(query = ADA) {
      const server = new Journal<ServerSocket>();
      world = await setup({
        handleOpen: (socket) => server.note('open', socket),
        handleBinary: (bytes) => server.note([...bytes].join(' ')),
        handleText: (text) => server.note(text),
        handleClose: () => server.note('close'),
      });
      const client = new Journal<void>();
      const handler: TopicDataHandler = {
        handleOpen: () => client.note('open'),
        handleBinary: (bytes) => client.note([...bytes].join(' ')),
        handleText: (text) => client.note(text),
        handleClose: (code, reason) => client.note(`close ${code} ${reason}`.trim()),
      };
      const socket = world.transport.open(query, handler);
      return { server, client, socket, notesAtReturn: [...client.notes] };
    }

    async function openBoth(query = ADA) {
      const all = await open(query);
      await all.client.until('open');
      const serverSocket = await all.server.until('open');
      return { ...all, serverSocket: serverSocket! };
    }

    it('sends the client id of the socket [EX-4] [EX-51]', async () => {
      const { serverSocket } = await openBoth();
      expect(serverSocket.query).toEqual(ADA);
    });

    it('calls no callback before open() has returned', async () => {
      const { client, notesAtReturn } = await open();
      await client.until('open');
      expect(notesAtReturn).toEqual([]);
    });

    it('sends no token when there is none', async () => {
      const { serverSocket } = await openBoth({ clientId: 'ada', resumeToken: undefined });
      expect(serverSocket.query).toEqual({ clientId: 'ada', resumeToken: undefined });
    });

    it('carries text and bytes to the master, in order', async () => {
      const { server, socket } = await openBoth();
      socket.sendBinary(new Uint8Array([1, 2]));
      socket.sendText('PING');
      socket.sendBinary(new Uint8Array([9, 3, 9]).subarray(1, 2));
      await server.until('3');
      expect(server.notes).toEqual(['open', '1 2', 'PING', '3']);
    });

    it('carries text and bytes to the client, in order', async () => {
      const { client, serverSocket } = await openBoth();
      serverSocket.sendText('PING');
      serverSocket.sendBinary(new Uint8Array([1, 2]));
      serverSocket.sendText('PONG');
      await client.until('PONG');
      expect(client.notes).toEqual(['open', 'PING', '1 2', 'PONG']);
    });

    it('lets the sender reuse its bytes', async () => {
      const { server, socket } = await openBoth();
      const bytes = new Uint8Array([1]);
      socket.sendBinary(bytes);
      bytes[0] = 2;
      await server.until('1');
    });

    it('carries a large frame in one piece', async () => {
      const { server, socket } = await openBoth();
      const bytes = new Uint8Array(300_000).fill(7);
      socket.sendBinary(bytes);
      await server.until([...bytes].join(' '));
    });

    it('passes on the code and the reason of the master', async () => {
      const { client, serverSocket, socket } = await openBoth();
      serverSocket.close(4004, 'unknown client');
      await client.until('close 4004 unknown client');
      socket.sendText('too late');
      socket.close();
      expect(client.notes).toEqual(['open', 'close 4004 unknown client']);
    });

    it('says 1006 when the link breaks', async () => {
      const { client, serverSocket } = await openBoth();
      serverSocket.cut();
      await client.until('close 1006');
    });

    it('closes with 1006 when there is no master, without an earlier event', async () => {
      const gone = await setup(SILENT);
      await gone.close();
      const client = new Journal<void>();
      gone.transport.open(ADA, {
        handleOpen: () => client.note('open'),
        handleBinary: () => client.note('bytes'),
        handleText: (text) => client.note(text),
        handleClose: (code) => client.note(`close ${code}`),
      });
      await client.until('close 1006');
      expect(client.notes).toEqual(['close 1006']);
    });

    it('tells both sides when the client closes, the client once', async () => {
      const { server, client, socket } = await openBoth();
      socket.close();
      socket.close();
      await server.until('close');
      await client.until('close 1000');
      expect(client.notes).toEqual(['open', 'close 1000']);
    });

    it('can be closed before it is open', async () => {
      const { client, socket } = await open();
      socket.sendText('too early');
      socket.close();
      await client.untilStartsWith('close');
      expect(client.notes.filter((note) => note !== 'open')).toHaveLength(1);
    });

    it('counts nothing as buffered while it is idle', async () => {
      const { socket } = await openBoth();
      expect(socket.bufferedBytes).toBe(0);
    });
  });
}

const SILENT: ServerEvents = {
  handleOpen: () => undefined,
  handleBinary: () => undefined,
  handleText: () => undefined,
  handleClose: () => undefined,
};

/** Notes what happens, and lets a test wait for it. */
class Journal<V> {
  readonly notes: string[] = [];
  readonly #values = new Map<string, V | undefined>();
  #waiting: { readonly matches: (note: string) => boolean; readonly resolve: () => void }[] = [];

  note(note: string, value?: V): void {
    this.notes.push(note);
    this.#values.set(note, value);
    this.#waiting = this.#waiting.filter(({ matches, resolve }) => {
      if (!matches(note)) return true;
      resolve();
      return false;
    });
  }

  async until(note: string): Promise<V | undefined> {
    await this.#until((other) => other === note);
    return this.#values.get(note);
  }

  async untilStartsWith(start: string): Promise<void> {
    await this.#until((note) => note.startsWith(start));
  }

  #until(matches: (note: string) => boolean): Promise<void> {
    if (this.notes.some(matches)) return Promise.resolve();
    return new Promise((resolve) => this.#waiting.push({ matches, resolve }));
  }
}
