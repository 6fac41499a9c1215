import type { CDPSession, Locator, Page } from '@playwright/test';
import { expect } from '../fixtures/test.ts';

/**
 * Has the page do without WebGL, as on machines that have none: where the processor draws, the picture would take the
 * time of the phones.
 */
export async function withoutWebGl(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...args: unknown[]
    ) {
      return String(args[0]).startsWith('webgl')
        ? null
        : Reflect.apply(getContext as (...all: unknown[]) => unknown, this, args);
    } as typeof getContext;
  });
}

/** The big screen of a party. */
export class PartyScreenPage {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  async open(): Promise<void> {
    await withoutWebGl(this.page);
    await this.page.goto('/party');
    await expect(this.page.getByRole('heading', { name: 'Ubi-Party' })).toBeVisible();
  }

  async expectPhase(phase: string, timeout = 60_000): Promise<void> {
    await expect(this.page.locator('.party-screen')).toHaveAttribute('data-phase', phase, {
      timeout,
    });
  }

  async expectPlayers(count: number): Promise<void> {
    await expect(this.page.getByText(`${count} players`)).toBeVisible();
  }

  start(): Promise<void> {
    return this.page.getByRole('button', { name: 'Start', exact: true }).click();
  }

  /** Names of the table, the best first. */
  async table(): Promise<string[]> {
    return this.page.locator('tbody th').allInnerTexts();
  }
}

interface Finger {
  readonly x: number;
  readonly y: number;
}

/** A player's phone, with real fingers: one on the stick or wheel, one on the button. */
export class PartyPhonePage {
  readonly page: Page;
  readonly name: string;
  #session: CDPSession | undefined;
  /** Fingers that are down, by what they are on. */
  readonly #down = new Map<'steer' | 'press', Finger>();

  constructor(page: Page, name: string) {
    this.page = page;
    this.name = name;
  }

  async join(): Promise<void> {
    await this.page.goto('/party/play');
    await this.page.getByRole('textbox', { name: 'Your name' }).fill(this.name);
    await this.page.getByRole('button', { name: 'Join' }).tap();
    await expect(this.page.getByText(this.name, { exact: true }).first()).toBeVisible();
  }

  /** Ready, if the phone still asks for it. */
  async ready(): Promise<void> {
    const button = this.page.getByRole('button', { name: /^Ready( for the next game)?$/ });
    if (await button.isVisible()) await button.tap({ timeout: 2000 }).catch(() => undefined);
  }

  /** Moves the thumb, each axis from -1 to 1; positive is away from the player. */
  async steer(x: number, y: number): Promise<void> {
    const pad = this.page.getByRole('application');
    const middle = await middleOf(pad);
    if (!middle) return;
    if (!this.#down.has('steer')) await this.#put('steer', middle);
    await this.#put('steer', { x: middle.x + x * 90, y: middle.y - y * 90 });
  }

  async press(): Promise<void> {
    const pad = this.page.locator('[data-pad]');
    const middle = await middleOf(pad);
    if (!middle) return;
    await this.#put('press', middle);
    await this.#lift('press');
  }

  async release(): Promise<void> {
    for (const finger of [...this.#down.keys()]) await this.#lift(finger);
  }

  async #put(finger: 'steer' | 'press', at: Finger): Promise<void> {
    const isNew = !this.#down.has(finger);
    this.#down.set(finger, at);
    await this.#send(isNew ? 'touchStart' : 'touchMove');
  }

  async #lift(finger: 'steer' | 'press'): Promise<void> {
    this.#down.delete(finger);
    await this.#send('touchEnd');
  }

  async #send(type: 'touchStart' | 'touchMove' | 'touchEnd'): Promise<void> {
    this.#session ??= await this.page.context().newCDPSession(this.page);
    const touchPoints = [...this.#down].map(([finger, { x, y }]) => ({
      x,
      y,
      id: finger === 'steer' ? 0 : 1,
    }));
    await this.#session.send('Input.dispatchTouchEvent', { type, touchPoints });
  }
}

/** Undefined when it is not there: the round has ended meanwhile. */
async function middleOf(locator: Locator): Promise<Finger | undefined> {
  if (!(await locator.isVisible())) return undefined;
  const box = await locator.boundingBox({ timeout: 2000 }).catch(() => null);
  return box === null ? undefined : { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}
