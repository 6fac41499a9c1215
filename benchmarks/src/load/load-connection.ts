import { randomBytes } from 'node:crypto';
import { connect, type Socket } from 'node:net';
import { clientFrame, OPCODE } from './frames.ts';

/**
 * One read buffer for all connections: a chunk is verified before the next read starts, and a warm
 * buffer keeps the load generator light.
 */
const READ_BUFFER = Buffer.alloc(256 * 1024);
const HEADER_END = '\r\n\r\n';
const PONG_FRAME = clientFrame(OPCODE.text, Buffer.from('PONG'));
const CLOSE_FRAME = clientFrame(OPCODE.close, Buffer.from([0x03, 0xe8]));

/** Takes what a broker sends. */
export interface StreamReceiver {
  /** Takes the next bytes of the stream; borrowed. */
  push(chunk: Buffer): void;
  /** Called for each text frame PING; set by the connection, which answers it. */
  onPing: () => void;
  /** The connection ended before it was closed. */
  handleEnd(reason: string): void;
}

/** A WebSocket client of the least work: whole encoded frames out, bytes in. */
export class LoadConnection {
  readonly #socket: Socket;
  readonly #receiver: StreamReceiver;
  #closing = false;

  private constructor(socket: Socket, receiver: StreamReceiver) {
    this.#socket = socket;
    this.#receiver = receiver;
    receiver.onPing = () => this.send(PONG_FRAME);
  }

  /** @param url of the broker's socket, `ws://host:port/path?query` */
  static open(url: string, receiver: StreamReceiver): Promise<LoadConnection> {
    return new Promise((resolve, reject) => {
      const { hostname, port, pathname, search } = new URL(url);
      let opened: LoadConnection | undefined;
      let header = '';
      const handleBytes = (bytes: Buffer): void => {
        if (opened !== undefined) {
          if (opened.#closing) return;
          receiver.push(bytes);
          return;
        }
        header += bytes.toString('latin1');
        const end = header.indexOf(HEADER_END);
        if (end < 0) return;
        if (!header.startsWith('HTTP/1.1 101')) {
          reject(new Error(`${url} did not open a WebSocket: ${header.split('\r\n')[0]}`));
          socket.destroy();
          return;
        }
        opened = new LoadConnection(socket, receiver);
        const rest = Buffer.from(header.slice(end + HEADER_END.length), 'latin1');
        resolve(opened);
        if (rest.length > 0) receiver.push(rest);
      };
      const socket = connect({
        host: hostname,
        port: Number(port),
        noDelay: true,
        onread: {
          buffer: READ_BUFFER,
          callback: (byteLength) => {
            handleBytes(READ_BUFFER.subarray(0, byteLength));
            return true;
          },
        },
      });
      socket.on('error', (error) => {
        reject(error);
        if (opened !== undefined) opened.#noteEnd(error.message);
      });
      socket.on('close', () => {
        if (opened !== undefined) opened.#noteEnd('the broker closed the connection');
      });
      socket.on('connect', () => {
        socket.write(
          `GET ${pathname}${search} HTTP/1.1\r\nHost: ${hostname}:${port}\r\n` +
            'Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n' +
            `Sec-WebSocket-Key: ${randomBytes(16).toString('base64')}\r\n\r\n`,
        );
      });
    });
  }

  /** Sends bytes that are whole client frames already. */
  send(frames: Buffer): void {
    this.#socket.write(frames);
  }

  /** Says goodbye; resolves when the connection is gone. */
  close(): Promise<void> {
    this.#closing = true;
    return new Promise((resolve) => {
      if (this.#socket.destroyed) return resolve();
      this.#socket.once('close', () => resolve());
      this.#socket.end(CLOSE_FRAME);
    });
  }

  #noteEnd(reason: string): void {
    if (!this.#closing) this.#receiver.handleEnd(reason);
  }
}
