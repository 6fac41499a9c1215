import { connect, type Socket } from 'node:net';
import type { StreamReceiver } from './load-connection.ts';

/** One for all connections: a chunk is verified before the next read starts. */
const READ_BUFFER = Buffer.alloc(256 * 1024);

/** How a connection to a broker of a protocol on TCP begins. */
export interface Greeting {
  readonly broker: string;
  readonly port: number;
  /** What the client says first. */
  readonly hello: Buffer;
  /** Where the answer ends, in what came so far; undefined while it is not complete. */
  answerEnd(bytes: Buffer): number | undefined;
  /** What answers a ping of the broker. */
  readonly pong?: Buffer;
}

/** A client of a protocol on TCP, of the least work: whole encoded messages out, bytes in. */
export class StreamConnection {
  readonly #socket: Socket;
  #closing = false;

  private constructor(socket: Socket) {
    this.#socket = socket;
  }

  /** Resolves when the broker has answered. */
  static open(greeting: Greeting, receiver: StreamReceiver): Promise<StreamConnection> {
    const { broker, port, hello, pong } = greeting;
    return new Promise((resolve, reject) => {
      let opened: StreamConnection | undefined;
      let answer: Buffer = Buffer.alloc(0);
      const handleBytes = (bytes: Buffer): void => {
        if (opened !== undefined) {
          if (!opened.#closing) receiver.push(bytes);
          return;
        }
        answer = Buffer.concat([answer, bytes]);
        const end = greeting.answerEnd(answer);
        if (end === undefined) return;
        const connection = new StreamConnection(socket);
        opened = connection;
        if (pong !== undefined) receiver.onPing = () => connection.send(pong);
        resolve(connection);
        if (end < answer.length) receiver.push(answer.subarray(end));
      };
      const socket = connect({
        host: '127.0.0.1',
        port,
        noDelay: true,
        onread: {
          buffer: READ_BUFFER,
          callback: (byteLength) => {
            handleBytes(READ_BUFFER.subarray(0, byteLength));
            return true;
          },
        },
      });
      socket.on('error', reject);
      socket.on('close', () => {
        if (opened !== undefined && !opened.#closing) {
          receiver.handleEnd(`${broker} closed the connection`);
        }
      });
      socket.on('connect', () => socket.write(hello));
    });
  }

  /** Sends bytes that are whole messages already. */
  send(messages: Buffer): void {
    this.#socket.write(messages);
  }

  /** Resolves when the connection is gone. */
  close(): Promise<void> {
    this.#closing = true;
    return new Promise((resolve) => {
      if (this.#socket.destroyed) return resolve();
      this.#socket.once('close', () => resolve());
      this.#socket.end();
    });
  }
}
