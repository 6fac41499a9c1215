import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { createServer, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

import { buildBrowserWorkers, SANDBOX_WORKER_FILES } from '@ubii/pm-sandbox/build';
import { ASSETS_PATH } from '@ubii/pm-sandbox';
import { AssetFolders } from '@ubii/pm-sandbox/node';
import { readAssetSet, writeAssetSets } from '@ubii/vision/assets';
import { buildLibrary } from '@ubii/vision/library';
import { photoFile } from '@ubii/vision/testing';
import { build } from 'esbuild';
import { chromium } from '@playwright/test';

import { CHROMIUM_FLAGS } from '../browser/chromium.ts';
import type { Part } from '../parts/shared-parts.ts';
import type { Seeing } from './seeing-page.ts';

const PAGE = '<!doctype html><title>seeing</title><script src="/seeing-page.js"></script>';
const SCRIPTS = ['seeing-page', 'human-worker'];
const inFolder = (name: string): string => fileURLToPath(new URL(`./${name}`, import.meta.url));

/** A page that is served to this machine alone. */
interface ServedSeeing {
  readonly url: string;
  stop(): Promise<void>;
}

/** Builds and serves the page, workers, asset sets and photographs, with the policies of a master. */
async function serveSeeing(): Promise<ServedSeeing> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-bench-seeing-'));
  await Promise.all([buildBrowserWorkers(folder), buildScripts(folder)]);
  await buildLibrary(join(folder, 'vision.js'));
  writeAssetSets(join(folder, 'sets'), join(folder, 'vision.js'));
  const sets = new AssetFolders([join(folder, 'sets')]);
  // The library finds its models, and the program of its backend, by name.
  const ofLibrary = { ...readAssetSet('centernet-coco'), ...readAssetSet('tfjs-wasm') };
  const policies = new Map(Object.values(SANDBOX_WORKER_FILES).map(({ path, csp }) => [path, csp]));

  async function answer(path: string, response: ServerResponse): Promise<void> {
    const [, room = '', ...rest] = path.split('/').map(decodeURIComponent);
    const name = rest.join('/');
    if (path === '/') {
      response.setHeader('content-type', 'text/html').end(PAGE);
    } else if (room === 'photos') {
      response.end(photoFile(name));
    } else if (room === 'human' && ofLibrary[name] !== undefined) {
      response.setHeader(
        'content-type',
        name.endsWith('.wasm') ? 'application/wasm' : 'text/plain',
      );
      response.end(ofLibrary[name]);
    } else if (path.startsWith(`${ASSETS_PATH}/`)) {
      const [set, hash, ...parts] = rest as [string, string, ...string[]];
      if (hash === 'manifest.json') response.end(JSON.stringify(await sets.manifest(set)));
      else response.end(await readFile(await sets.pathOf(set, parts.join('/'))));
    } else if (policies.has(path) || SCRIPTS.some((script) => path === `/${script}.js`)) {
      const policy = policies.get(path);
      if (policy !== undefined) response.setHeader('content-security-policy', policy);
      response.setHeader('content-type', 'text/javascript');
      response.end(await readFile(join(folder, path)));
    } else {
      response.writeHead(404).end();
    }
  }
  const server = createServer((request, response) => {
    answer(request.url ?? '/', response).catch(() => response.writeHead(500).end());
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

async function buildScripts(folder: string): Promise<void> {
  await build({
    entryPoints: SCRIPTS.map((script) => inFolder(`${script}.ts`)),
    outdir: folder,
    bundle: true,
    minify: true,
    format: 'iife',
    logLevel: 'warning',
  });
}

/** A headless browser with the page that has pictures detected. */
export interface SeeingBrowser extends Part, Seeing {}

/** @param executablePath of Chromium */
export async function openSeeingBrowser(executablePath: string): Promise<SeeingBrowser> {
  const served = await serveSeeing();
  const browser = await chromium.launch({ executablePath, args: CHROMIUM_FLAGS });
  const page = await browser.newPage();
  await page.goto(served.url);
  return {
    see: (...args) => page.evaluate((given) => globalThis.seeing.see(...given), args),
    measure: (...args) => page.evaluate((given) => globalThis.seeing.measure(...given), args),
    stop: async () => {
      await browser.close();
      await served.stop();
    },
  };
}

declare global {
  // Of the page.
  var seeing: Seeing;
}
