import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { chromium, type CDPSession, type Page } from '@playwright/test';
import { CHROMIUM_FLAGS, findChromium } from '../browser/chromium.ts';
import type { Part } from '../parts/shared-parts.ts';

/** As of a laptop. */
const VIEWPORT = { width: 1440, height: 900 };
/** A turn of a mouse wheel, pixels, and how often, milliseconds. */
const WHEEL = { deltaPx: 120, everyMs: 40 };
const TURN_AFTER = 40;

/** A page with a list of topics that can be scrolled. */
export interface ListPage {
  readonly page: Page;
  /** Milliseconds from one frame to the next, while `during` runs. */
  frames(during: () => Promise<void>): Promise<number[]>;
  /** Scrolls with the wheel, down and up again. */
  scroll(forMs: number): Promise<void>;
  /** Bytes of the heap after a collection. */
  heapBytes(): Promise<number>;
  /** Text of the visible rows. */
  rows(): Promise<string>;
  close(): Promise<void>;
}

export interface ListBrowser extends Part {
  open(url: string): Promise<ListPage>;
}

export async function startListBrowser(): Promise<ListBrowser> {
  const browser = await chromium.launch({
    executablePath: findChromium()!,
    args: CHROMIUM_FLAGS,
  });
  return {
    async open(url) {
      const context = await browser.newContext({ viewport: VIEWPORT });
      const page = await context.newPage();
      await page.goto(url, { waitUntil: 'commit' });
      const session = await context.newCDPSession(page);
      return listPage(page, session, () => context.close());
    },
    stop: () => browser.close(),
  };
}

function listPage(page: Page, session: CDPSession, close: () => Promise<void>): ListPage {
  const list = page.getByRole('treegrid');
  return {
    page,
    async frames(during) {
      await page.evaluate(WATCH_FRAMES);
      await during();
      return page.evaluate(() => (globalThis as unknown as WatchedPage).endFrames());
    },
    async scroll(forMs) {
      const box = (await list.boundingBox())!;
      await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
      const endMs = performance.now() + forMs;
      for (let turn = 0; performance.now() < endMs; turn++) {
        const isDown = Math.floor(turn / TURN_AFTER) % 2 === 0;
        const delta = isDown ? WHEEL.deltaPx : -WHEEL.deltaPx;
        await Promise.all([page.mouse.wheel(0, delta), sleep(WHEEL.everyMs)]);
      }
    },
    async heapBytes() {
      await session.send('HeapProfiler.collectGarbage');
      const { usedSize } = await session.send('Runtime.getHeapUsage');
      return usedSize;
    },
    rows: () => list.innerText(),
    close,
  };
}

interface WatchedPage {
  /** Stops watching. @returns what was seen */
  endFrames(): number[];
}

/** Script of the page, as text: what compilers add to functions is not there. */
const WATCH_FRAMES = `(() => {
  const intervals = [];
  let lastMs;
  let isOn = true;
  requestAnimationFrame(function frame(nowMs) {
    if (!isOn) return;
    if (lastMs !== undefined) intervals.push(nowMs - lastMs);
    lastMs = nowMs;
    requestAnimationFrame(frame);
  });
  globalThis.endFrames = () => {
    isOn = false;
    return intervals;
  };
})()`;

/** A page that is served to this machine alone. */
export interface BareList extends Part {
  readonly url: string;
}

export async function serveBareList(): Promise<BareList> {
  const html = await readFile(join(import.meta.dirname, 'bare-list.html'));
  const server = createServer((_, response) => {
    response.setHeader('content-type', 'text/html').end(html);
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${(server.address() as AddressInfo).port}/`,
    stop: async () => {
      server.closeAllConnections();
      server.close();
    },
  };
}
