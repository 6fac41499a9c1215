import { chromium } from '@playwright/test';
import { CHROMIUM_FLAGS } from '../browser/chromium.ts';
import type { Part } from '../parts/shared-parts.ts';
import type { Seeing } from './seeing-page.ts';
import { serveSeeing } from './serve-seeing.ts';

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
