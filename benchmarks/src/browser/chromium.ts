import { existsSync } from 'node:fs';
import { chromium } from '@playwright/test';
import type { ModuleCalls } from './calls-page.ts';
import { servePage } from './serve-page.ts';

const SYSTEM_CHROMIUM = '/usr/bin/chromium';
/** How browsers to measure in are started. */
export const CHROMIUM_FLAGS = [
  // The browser's own sandbox does not start as root.
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  ...(process.env['UBII_BENCH_GPU'] === '1' ? [] : ['--disable-gpu']),
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** The browser to measure in: `UBII_CHROMIUM`, the system's, or Playwright's; undefined: there is none. */
export function findChromium(): string | undefined {
  const found = [process.env['UBII_CHROMIUM'], SYSTEM_CHROMIUM, chromium.executablePath()];
  return found.find((path) => path !== undefined && path !== '' && existsSync(path));
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
