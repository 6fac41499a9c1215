import { copyFile, mkdtemp, readFile, rm } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { buildBrowserWorkers, SANDBOX_WORKER_FILES } from '@ubii/pm-sandbox/build';
import { build } from 'esbuild';
import { chromium } from '@playwright/test';

import { CHROMIUM_FLAGS, findChromium } from '../browser/chromium.ts';
import type { ModuleCalls } from './calls-page.ts';

const PAGE = '<!doctype html><title>calls of modules</title><script src="/page.js"></script>';
const BARE_WORKER = 'bare-web-worker.js';
const inFolder = (name: string): string => fileURLToPath(new URL(`./${name}`, import.meta.url));

/** A page that is served to this machine alone. */
interface ServedPage {
  readonly url: string;
  stop(): Promise<void>;
}

/** Builds and serves the page that calls modules, with the policies a master sends for their workers. */
async function servePage(): Promise<ServedPage> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-bench-page-'));
  await buildBrowserWorkers(folder);
  await build({
    entryPoints: [inFolder('calls-page.ts')],
    outfile: join(folder, 'page.js'),
    bundle: true,
    minify: true,
    format: 'iife',
    logLevel: 'warning',
  });
  await copyFile(inFolder(BARE_WORKER), join(folder, BARE_WORKER));
  const policies = new Map(Object.values(SANDBOX_WORKER_FILES).map(({ path, csp }) => [path, csp]));
  const scripts = new Set(['/page.js', `/${BARE_WORKER}`, ...policies.keys()]);
  const server = createServer((request, response) => {
    const path = request.url ?? '/';
    // Without these two, browsers tell the time in steps of 100 µs.
    response.setHeader('cross-origin-opener-policy', 'same-origin');
    response.setHeader('cross-origin-embedder-policy', 'require-corp');
    const policy = policies.get(path);
    if (policy !== undefined) response.setHeader('content-security-policy', policy);
    if (path === '/') {
      response.setHeader('content-type', 'text/html').end(PAGE);
    } else if (scripts.has(path)) {
      response.setHeader('content-type', 'text/javascript');
      void readFile(join(folder, path)).then((text) => response.end(text));
    } else {
      response.writeHead(404).end();
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`,
    stop: async () => {
      server.closeAllConnections();
      server.close();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

/** A headless browser with the page that calls modules. */
export interface BrowserPage {
  measure: ModuleCalls['measure'];
  stop(): Promise<void>;
}

export async function openBrowserPage(): Promise<BrowserPage> {
  const served = await servePage();
  const browser = await chromium.launch({ executablePath: findChromium()!, args: CHROMIUM_FLAGS });
  const page = await browser.newPage();
  await page.goto(served.url);
  return {
    measure: (...args) =>
      page.evaluate(
        (given) =>
          (globalThis as unknown as { moduleCalls: ModuleCalls }).moduleCalls.measure(...given),
        args,
      ),
    stop: async () => {
      await browser.close();
      await served.stop();
    },
  };
}
