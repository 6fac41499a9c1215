import type { CDPSession, Locator, Page } from '@playwright/test';

interface Point {
  readonly x: number;
  readonly y: number;
}

/** Real fingers: touches the browser makes pointer events, clicks and scrolling of by itself. */
export class Fingers {
  readonly #page: Page;
  readonly #session: CDPSession;

  private constructor(page: Page, session: CDPSession) {
    this.#page = page;
    this.#session = session;
  }

  static async on(page: Page): Promise<Fingers> {
    return new Fingers(page, await page.context().newCDPSession(page));
  }

  async #send(type: 'touchStart' | 'touchMove' | 'touchEnd', points: readonly Point[]) {
    const touchPoints = points.map(({ x, y }, id) => ({ x, y, id }));
    await this.#session.send('Input.dispatchTouchEvent', { type, touchPoints });
  }

  async tap(at: Point): Promise<void> {
    await this.#send('touchStart', [at]);
    await this.#send('touchEnd', []);
  }

  async tapOn(locator: Locator): Promise<void> {
    await this.tap(await middleOf(locator));
  }

  /** Puts a finger down, waits until something is seen, and lifts it. */
  async hold(at: Point, until: () => Promise<void>): Promise<void> {
    await this.#send('touchStart', [at]);
    await until();
    await this.#send('touchEnd', []);
  }

  async drag(from: Point, to: Point): Promise<void> {
    await this.#send('touchStart', [from]);
    // The first step is a long one: on a busy machine, a finger that hardly moved was held still.
    for (let step = 3; step <= 8; step += 1) {
      await this.#send('touchMove', [between(from, to, step / 8)]);
      await this.#frame();
    }
    await this.#send('touchEnd', []);
  }

  /** Two fingers, from two places to two others. */
  async pinch(from: readonly [Point, Point], to: readonly [Point, Point]): Promise<void> {
    await this.#send('touchStart', [from[0]]);
    await this.#send('touchStart', [...from]);
    for (let step = 1; step <= 8; step += 1) {
      const share = step / 8;
      await this.#send('touchMove', [
        between(from[0], to[0], share),
        between(from[1], to[1], share),
      ]);
      await this.#frame();
    }
    await this.#send('touchEnd', []);
  }

  async #frame(): Promise<void> {
    await this.#page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  }
}

const between = (a: Point, b: Point, share: number): Point => ({
  x: a.x + (b.x - a.x) * share,
  y: a.y + (b.y - a.y) * share,
});

export async function middleOf(locator: Locator): Promise<Point> {
  const box = await locator.boundingBox();
  if (box === null) throw new Error('It is not on the page.');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}
