import type { Browser } from '@playwright/test';

/** Pixels of the picture for each pixel of its page. */
export const SCALE = 1.25;
/** 1600 x 980 in the picture. */
const SIZE = { width: 1280, height: 784 };

/** Writes a picture of a desk with a phone over its lower right. */
export async function layOver(
  browser: Browser,
  desk: Buffer,
  phone: Buffer,
  path: string,
): Promise<void> {
  const page = await browser.newPage({ viewport: SIZE, deviceScaleFactor: SCALE });
  await page.setContent(`
    <style>
      body { margin: 0; background: linear-gradient(160deg, #22272c, #0b0d0f); overflow: hidden; }
      img { position: absolute; box-shadow: 0 0 0 1px #ffffff24, 0 24px 64px #000000a0; }
      .desk { left: 28px; top: 28px; width: 1168px; border-radius: 12px; }
      .phone { right: 24px; bottom: 24px; width: 292px; border-radius: 20px; }
    </style>
    <img class="desk" src="${urlOf(desk)}">
    <img class="phone" src="${urlOf(phone)}">`);
  await page.screenshot({ path });
  await page.close();
}

const urlOf = (png: Buffer): string => `data:image/png;base64,${png.toString('base64')}`;
