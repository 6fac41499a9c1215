import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { WebSocketServer } from 'ws';
import type { Part } from '../parts/shared-parts.ts';

/** It runs a callback each frame, reads what comes, and draws nothing. */
const HTML = `<!doctype html><title>bare screen</title><script>
new WebSocket(location.href.replace('http', 'ws')).onmessage = ({ data }) => JSON.parse(data);
requestAnimationFrame(function frame() { requestAnimationFrame(frame); });
</script>`;

/** The minimum that shows a press: a page that gets one message. */
export interface BareScreen extends Part {
  readonly url: string;
  press(seat: number, isDown: boolean): void;
}

export async function serveBareScreen(): Promise<BareScreen> {
  const server = createServer((_, response) => {
    response.setHeader('content-type', 'text/html').end(HTML);
  });
  const sockets = new WebSocketServer({ server });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`,
    press(seat, wasPressed) {
      const text = JSON.stringify({ state: { carts: [{ seat, wasPressed }] } });
      for (const socket of sockets.clients) socket.send(text);
    },
    stop: async () => {
      for (const socket of sockets.clients) socket.terminate();
      sockets.close();
      server.closeAllConnections();
      server.close();
    },
  };
}
