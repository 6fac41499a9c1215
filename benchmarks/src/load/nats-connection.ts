import { connect, type Socket } from 'node:net';
import type { StreamReceiver } from './load-connection.ts';
import { SUBSCRIPTION } from './nats-wire.ts';

/** One for all connections: a chunk is verified before the next read starts. */
const READ_BUFFER = Buffer.alloc(256 * 1024);
const PONG = Buffer.from('PONG\r\n');
const HELLO = 'CONNECT {"verbose":false,"pedantic":false,"lang":"benchmark","version":"1"}\r\n';

/** A client of NATS of the least work: whole encoded messages out, bytes in. */
export class NatsConnection {
  readonly #socket: Socket;
  #closing = false;

  private constructor(socket: Socket, receiver: StreamReceiver) {
    this.#socket = socket;
    receiver.onPing = () => this.send(PONG);
  }

  /** Connects, and subscribes to a subject if one is given. */
  static open(
    port: number,
    subject: string | undefined,
    receiver: StreamReceiver,
  ): Promise<NatsConnection> {
    return new Promise((resolve, reject) => {
      let opened: NatsConnection | undefined;
      let greeting = '';
      const handleBytes = (bytes: Buffer): void => {
        if (opened !== undefined) {
          if (!opened.#closing) receiver.push(bytes);
          return;
        }
        // INFO, and PONG once the server has the subscription.
        greeting += bytes.toString('latin1');
        const end = greeting.indexOf('PONG\r\n');
        if (end < 0) return;
        opened = new NatsConnection(socket, receiver);
        resolve(opened);
        const rest = Buffer.from(greeting.slice(end + PONG.length), 'latin1');
        if (rest.length > 0) receiver.push(rest);
      };
      const socket = connect({
        ...{ host: '127.0.0.1', port, noDelay: true },
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
        if (opened !== undefined && !opened.#closing)
          receiver.handleEnd('NATS closed the connection');
      });
      const subscribe = subject === undefined ? '' : `SUB ${subject} ${SUBSCRIPTION}\r\n`;
      socket.on('connect', () => socket.write(`${HELLO}${subscribe}PING\r\n`));
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
