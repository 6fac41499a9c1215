import type { Browser } from '@playwright/test';

/** Pixels of the picture for each pixel of its page. */
export const SCALE = 1.25;
const WIDTH = 1280;
/** One phone lies over the lower right of the desk, several stand in a row over its lower edge. */
const ONE = { height: 784, desk: 1168, phone: 292, place: 'right: 24px' };
const SEVERAL = { height: 930, desk: 1224, phone: 180, place: 'inset-inline: 0; margin: auto' };

/** Writes a picture of a desk with phones over it. */
export async function layOver(
  browser: Browser,
  desk: Buffer,
  phones: readonly Buffer[],
  path: string,
): Promise<void> {
  const look = phones.length === 1 ? ONE : SEVERAL;
  const viewport = { width: WIDTH, height: look.height };
  const page = await browser.newPage({ viewport, deviceScaleFactor: SCALE });
  await page.setContent(`
    <style>
      body { margin: 0; background: linear-gradient(160deg, #22272c, #0b0d0f); overflow: hidden; }
      img { box-shadow: 0 0 0 1px #ffffff24, 0 24px 64px #000000a0; }
      .desk { position: absolute; left: 28px; top: 28px; width: ${look.desk}px; border-radius: 12px; }
      .phones { position: absolute; bottom: 24px; display: flex; gap: 28px; width: fit-content; ${look.place}; }
      .phones img { width: ${look.phone}px; border-radius: 20px; }
    </style>
    <img class="desk" src="${urlOf(desk)}">
    <div class="phones">${phones.map((phone) => `<img src="${urlOf(phone)}">`).join('')}</div>`);
  await page.screenshot({ path });
  await page.close();
}

const urlOf = (png: Buffer): string => `data:image/png;base64,${png.toString('base64')}`;
