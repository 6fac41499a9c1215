import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';

import { WebSocketServer } from 'ws';
import { chromium, type Page } from '@playwright/test';
import { build } from 'esbuild';

import { CHROMIUM_FLAGS, findChromium } from '../browser/chromium.ts';
import type { Part } from '../parts/shared-parts.ts';
import type { ScreenWatch } from './screen-watch.ts';

/** It runs a callback each frame, reads what comes, and draws nothing. */
const HTML = `<!doctype html><title>bare screen</title><script>
new WebSocket(location.href.replace('http', 'ws')).onmessage = ({ data }) => JSON.parse(data);
requestAnimationFrame(function frame() { requestAnimationFrame(frame); });
</script>`;

/** The minimum that shows a press: a page that gets one message. */
interface BareScreen extends Part {
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

/** A page that is watched. */
export interface Screen {
  readonly page: Page;
  start(): Promise<void>;
  stop(): ReturnType<ScreenWatch['stop']>;
  /** Time that the page has spent in scripts so far, milliseconds. */
  scriptMs(): Promise<number>;
  close(): Promise<void>;
}

/** A headless browser that has WebGL, with a graphics card or without. */
export interface ScreenBrowser extends Part {
  /** @param draws false: the page does all that it does, but the calls that draw do nothing */
  open(url: string, draws?: boolean): Promise<Screen>;
}

/** WebGL on the processor. */
const SOFTWARE_WEBGL = [
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
];

const VIEWPORT = { width: 1280, height: 720 };

/** Script of the page, as text: what compilers add to functions is not there. */
const DRAW_NOTHING = `for (const name of [
  'drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced', 'drawRangeElements', 'clear',
]) WebGL2RenderingContext.prototype[name] = () => undefined;`;

export async function startScreenBrowser(): Promise<ScreenBrowser> {
  const { outputFiles } = await build({
    entryPoints: [join(import.meta.dirname, 'screen-watch.ts')],
    bundle: true,
    write: false,
    format: 'iife',
    logLevel: 'warning',
  });
  const hasCard = process.env['UBII_BENCH_GPU'] === '1';
  const flags = CHROMIUM_FLAGS.filter((flag) => flag !== '--disable-gpu');
  const browser = await chromium.launch({
    executablePath: findChromium()!,
    args: [...flags, ...(hasCard ? [] : SOFTWARE_WEBGL)],
  });
  // One context: a page that leads a party continues with what the page before stored.
  const context = await browser.newContext({ viewport: VIEWPORT });
  await context.addInitScript({ content: outputFiles[0]!.text });
  return {
    async open(url, draws = true) {
      const page = await context.newPage();
      if (!draws) await page.addInitScript(DRAW_NOTHING);
      await page.goto(url);
      const session = await context.newCDPSession(page);
      await session.send('Performance.enable');
      return {
        page,
        start: () => page.evaluate(() => globalThis.screenWatch.start()),
        stop: () => page.evaluate(() => globalThis.screenWatch.stop()),
        async scriptMs() {
          const { metrics } = await session.send('Performance.getMetrics');
          return 1000 * (metrics.find(({ name }) => name === 'ScriptDuration')?.value ?? NaN);
        },
        close: () => page.close(),
      };
    },
    stop: () => browser.close(),
  };
}

declare global {
  // Of the page.
  var screenWatch: ScreenWatch;
}
