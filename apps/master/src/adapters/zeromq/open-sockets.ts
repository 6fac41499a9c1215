import type { Socket } from 'node:net';

/** How long a connection may be still before the system asks whether its peer is there, milliseconds. */
const KEEP_ALIVE_MS = 60_000;

/** The sockets of one port, from their first moment to their last. */
export class OpenSockets {
  readonly #open = new Set<Socket>();

  add(socket: Socket): void {
    this.#open.add(socket);
    socket.setNoDelay(true).setKeepAlive(true, KEEP_ALIVE_MS);
    socket.on('error', () => socket.destroy());
    socket.on('close', () => this.#open.delete(socket));
  }

  destroyAll(): void {
    for (const socket of this.#open) socket.destroy();
  }
}
