import { connect, createServer, type AddressInfo, type Socket } from 'node:net';

/** A port in front of another one that a test can cut. */
export interface CuttablePort {
  readonly port: number;
  /** Breaks every connection, and refuses new ones. */
  cut(): void;
  /** Passes connections again. */
  heal(): void;
  close(): Promise<void>;
}

/** Opens a port of loopback that passes everything to `target`, in both directions. */
export async function openCuttablePort(target: number): Promise<CuttablePort> {
  const sockets = new Set<Socket>();
  let isCut = false;
  const keep = (socket: Socket): void => {
    sockets.add(socket);
    socket.setNoDelay(true);
    socket.on('error', () => undefined);
    socket.once('close', () => sockets.delete(socket));
  };
  const server = createServer((near) => {
    keep(near);
    if (isCut) return void near.destroy();
    const far = connect(target, '127.0.0.1');
    keep(far);
    near.pipe(far).pipe(near);
    near.once('close', () => far.destroy());
    far.once('close', () => near.destroy());
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const cutAll = (): void => sockets.forEach((socket) => void socket.destroy());
  return {
    port: (server.address() as AddressInfo).port,
    cut() {
      isCut = true;
      cutAll();
    },
    heal() {
      isCut = false;
    },
    async close() {
      const closed = new Promise((resolve) => server.close(resolve));
      cutAll();
      await closed;
    },
  };
}
