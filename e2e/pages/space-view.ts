import type { Locator, Page } from '@playwright/test';

/** Pixels of the screen from the middle of the picture: right and up. */
export interface Place {
  readonly right: number;
  readonly up: number;
}

/** The picture of space in the view of a topic. */
export class SpaceView {
  readonly page: Page;
  readonly frame: Locator;
  /** The canvas, whose label describes the drawing. */
  readonly canvas: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.frame = page.getByRole('group', { name: 'View in space' });
    this.canvas = this.frame.getByRole('img');
  }

  async open(topic: string): Promise<void> {
    await this.page.goto(`/topics/${encodeURIComponent(topic)}`);
  }

  /** A letter or name in the picture; letters stand at the tips of what is drawn. */
  word(text: string): Locator {
    return this.frame.locator('.labels i').getByText(text, { exact: true });
  }

  async placeOf(text: string): Promise<Place> {
    const frame = (await this.frame.boundingBox())!;
    const word = (await this.word(text).boundingBox())!;
    return {
      right: word.x + word.width / 2 - (frame.x + frame.width / 2),
      up: frame.y + frame.height / 2 - (word.y + word.height / 2),
    };
  }

  /** Approximate number of pixels with the colour of a token. */
  async pixelsOf(token: string): Promise<number> {
    const png = (await this.frame.screenshot({ animations: 'allow' })).toString('base64');
    return this.page.evaluate(
      async ([data, name]) => {
        const image = new Image();
        image.src = `data:image/png;base64,${data}`;
        await image.decode();
        const canvas = document.createElement('canvas');
        canvas.width = image.width;
        canvas.height = image.height;
        const context = canvas.getContext('2d', { willReadFrequently: true })!;
        // The token as the browser paints it
        const probe = document.body.appendChild(document.createElement('i'));
        probe.style.color = `var(${name})`;
        context.fillStyle = getComputedStyle(probe).color;
        probe.remove();
        context.fillRect(0, 0, 1, 1);
        const wanted = context.getImageData(0, 0, 1, 1).data;
        context.drawImage(image, 0, 0);
        const { data: pixels } = context.getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let at = 0; at < pixels.length; at += 4) {
          const isSame = [0, 1, 2].every(
            (part) => Math.abs(pixels[at + part]! - wanted[part]!) < 12,
          );
          if (isSame) count += 1;
        }
        return count;
      },
      [png, token] as const,
    );
  }
}
