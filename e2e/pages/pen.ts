import type { CDPSession, Page } from '@playwright/test';

interface Point {
  readonly x: number;
  readonly y: number;
}

/** A pen on a tablet: what it does comes as pointer events of a pen, with its pressure. */
export class Pen {
  readonly #page: Page;
  readonly #session: CDPSession;

  private constructor(page: Page, session: CDPSession) {
    this.#page = page;
    this.#session = session;
  }

  static async on(page: Page): Promise<Pen> {
    return new Pen(page, await page.context().newCDPSession(page));
  }

  async #send(type: 'mousePressed' | 'mouseMoved' | 'mouseReleased', at: Point, down: boolean) {
    await this.#session.send('Input.dispatchMouseEvent', {
      type,
      ...at,
      button: type === 'mouseMoved' && !down ? 'none' : 'left',
      buttons: down ? 1 : 0,
      clickCount: type === 'mouseMoved' ? 0 : 1,
      force: down ? 0.5 : 0,
      pointerType: 'pen',
    });
  }

  async tap(at: Point): Promise<void> {
    await this.#send('mouseMoved', at, false);
    await this.#send('mousePressed', at, true);
    await this.#send('mouseReleased', at, false);
  }

  async drag(from: Point, to: Point): Promise<void> {
    await this.#send('mouseMoved', from, false);
    await this.#send('mousePressed', from, true);
    for (let step = 1; step <= 8; step += 1) {
      const share = step / 8;
      const x = from.x + (to.x - from.x) * share;
      const y = from.y + (to.y - from.y) * share;
      await this.#send('mouseMoved', { x, y }, true);
      await this.#page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
    }
    await this.#send('mouseReleased', to, false);
  }

  /** Puts the pen down, as still as a hand is, waits until something is seen, and lifts it. */
  async hold(at: Point, until: () => Promise<void>): Promise<void> {
    await this.#send('mouseMoved', at, false);
    await this.#send('mousePressed', at, true);
    await this.#send('mouseMoved', { x: at.x + 2, y: at.y + 1 }, true);
    await until();
    await this.#send('mouseReleased', at, false);
  }
}
