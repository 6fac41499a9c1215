import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { chromium, type Page } from '@playwright/test';
import { build } from 'esbuild';
import { CHROMIUM_FLAGS, findChromium } from '../browser/chromium.ts';
import type { PageWatch } from './page-watch.ts';

/** As of a laptop. */
const VIEWPORT = { width: 1440, height: 900 };
/** Between two inputs, milliseconds: a mouse reports slightly more often than a screen draws. */
const INPUT_MS = 12;

/** A point of the page, pixels. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

/** A page with nodes and lines that can be panned, zoomed and dragged with the mouse. */
export interface CanvasPage {
  readonly page: Page;
  /** Calls something of the page's watch. */
  watch<K extends keyof PageWatch>(
    name: K,
    ...args: Parameters<PageWatch[K]>
  ): Promise<Awaited<ReturnType<PageWatch[K]>>>;
  close(): Promise<void>;
}

/** A headless browser whose pages are watched. */
export interface CanvasBrowser {
  open(url: string): Promise<CanvasPage>;
  stop(): Promise<void>;
}

export async function startCanvasBrowser(): Promise<CanvasBrowser> {
  const { outputFiles } = await build({
    entryPoints: [join(import.meta.dirname, 'page-watch.ts')],
    bundle: true,
    write: false,
    format: 'iife',
    logLevel: 'warning',
  });
  const browser = await chromium.launch({ executablePath: findChromium()!, args: CHROMIUM_FLAGS });
  const context = await browser.newContext({ viewport: VIEWPORT });
  await context.addInitScript({ content: outputFiles[0]!.text });
  return {
    open: async (url) => {
      const page = await context.newPage();
      await page.goto(url, { waitUntil: 'commit' });
      return {
        page,
        watch: (name, ...args) =>
          page.evaluate(
            ([key, given]) =>
              (globalThis as unknown as { pageWatch: Record<string, (...all: unknown[]) => never> })
                .pageWatch[key as string]!(...(given as unknown[])),
            [name, args] as const,
          ),
        close: () => page.close(),
      };
    },
    stop: () => browser.close(),
  };
}

/** Of one circle of the mouse, milliseconds. */
const CIRCLE_MS = 2000;

/**
 * Moves the mouse in circles through a point, and back to it.
 * @param away called once, where it is farthest from there
 */
export async function circle(
  { page }: CanvasPage,
  start: Point,
  radius: number,
  forMs: number,
  away: () => Promise<void>,
): Promise<void> {
  const circles = Math.max(1, Math.round(forMs / CIRCLE_MS));
  const beganMs = performance.now();
  let wasAway = false;
  for (;;) {
    const share = Math.min(1, (performance.now() - beganMs) / forMs);
    const angle = share * circles * 2 * Math.PI;
    const x = start.x + radius * Math.sin(angle);
    const y = start.y + radius * (1 - Math.cos(angle));
    await Promise.all([page.mouse.move(x, y), sleep(INPUT_MS)]);
    if (!wasAway && angle >= Math.PI) {
      wasAway = true;
      await away();
    }
    if (share === 1) return;
  }
}
