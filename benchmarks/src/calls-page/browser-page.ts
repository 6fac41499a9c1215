import { chromium } from '@playwright/test';
import { CHROMIUM_FLAGS, findChromium } from '../browser/chromium.ts';
import type { ModuleCalls } from './calls-page.ts';
import { servePage } from './serve-page.ts';

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
