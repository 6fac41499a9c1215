import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';

/** A page that is served to this machine alone. */
export interface BareCanvas {
  /** @returns address of the page with so many nodes */
  url(nodes: number): string;
  stop(): Promise<void>;
}

/** Serves plain nodes and lines that can be panned, zoomed and dragged: the least that a graph is. */
export async function serveBareCanvas(): Promise<BareCanvas> {
  const html = await readFile(join(import.meta.dirname, 'bare-canvas.html'));
  const server = createServer((_, response) => {
    // The time in fine steps.
    response.setHeader('cross-origin-opener-policy', 'same-origin');
    response.setHeader('cross-origin-embedder-policy', 'require-corp');
    response.setHeader('content-type', 'text/html').end(html);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    url: (nodes) => `http://127.0.0.1:${port}/?nodes=${nodes}`,
    stop: async () => {
      server.closeAllConnections();
      server.close();
    },
  };
}
