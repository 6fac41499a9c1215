import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { mkdtempSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { buildBrowserWorkers, SANDBOX_WORKER_FILES } from '../build/index.mjs';

const PAGE = '<!doctype html><title>sandboxes</title><script src="/page.js"></script>';
const PAGE_POLICY = "default-src 'self'; script-src 'self'; worker-src 'self'";

/**
 * Serves a page that runs modules in the sandboxes of browsers, with the policies a master sends.
 *
 * @returns {Promise<{ url: string; requests: string[]; close(): void }>} `requests` are the paths
 * that were asked for
 */
export async function serveBrowserPage() {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-sandbox-page-'));
  await buildBrowserWorkers(folder);
  await build({
    entryPoints: [fileURLToPath(new URL('browser-page.ts', import.meta.url))],
    outfile: join(folder, 'page.js'),
    bundle: true,
    format: 'iife',
    logLevel: 'warning',
  });
  const policies = new Map(Object.values(SANDBOX_WORKER_FILES).map(({ path, csp }) => [path, csp]));
  const requests = [];
  const server = createServer((request, response) => {
    const path = request.url ?? '/';
    requests.push(path);
    response.setHeader('content-security-policy', policies.get(path) ?? PAGE_POLICY);
    if (path === '/') return response.setHeader('content-type', 'text/html').end(PAGE);
    if (path !== '/page.js' && !policies.has(path)) return response.writeHead(404).end();
    response.setHeader('content-type', 'text/javascript').end(readFileSync(join(folder, path)));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}/`,
    requests,
    close() {
      server.closeAllConnections();
      server.close();
      rmSync(folder, { recursive: true });
    },
  };
}
