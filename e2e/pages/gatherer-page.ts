import { expect, type CDPSession, type Locator, type Page } from '@playwright/test';
import type { Person } from '../fixtures/test.ts';

/** The big screen of the smart-device gatherer. */
export class GathererPage {
  readonly page: Page;
  readonly session: Locator;
  readonly touches: Locator;
  readonly pairs: Locator;
  readonly distance: Locator;
  readonly #phones: Locator;

  constructor(page: Page) {
    this.page = page;
    this.session = page.getByRole('region', { name: 'Session', exact: true });
    this.touches = page.getByTestId('gathered-touch');
    this.pairs = page.getByTestId('near-pair');
    this.distance = page.getByRole('slider', { name: 'Near distance' });
    this.#phones = page.getByRole('list', { name: /^Phones/ }).getByRole('listitem');
  }

  async open(): Promise<void> {
    await this.page.goto('/examples/smart-device-gatherer');
  }

  async start(): Promise<void> {
    await this.session.getByRole('button', { name: 'Start' }).click();
    await this.expectSession('Running');
  }

  async stop(): Promise<void> {
    await this.session.getByRole('button', { name: 'Stop' }).click();
    await this.expectSession('Stopped');
  }

  async expectSession(word: string): Promise<void> {
    await expect(this.session.getByRole('status')).toContainText(word);
  }

  /** The row of a phone, by the name of its user. */
  phone(name: string): Locator {
    return this.#phones.filter({ hasText: name });
  }

  async expectPhones(...names: string[]): Promise<void> {
    await expect(this.#phones).toHaveCount(names.length);
    for (const name of names) await expect(this.phone(name)).toBeVisible();
  }

  async idOf(name: string): Promise<string> {
    return (await this.phone(name).getAttribute('data-client')) ?? '';
  }
}

/** Somebody with the page Smart device, and their fingers on its pad. */
export class TouchedPhone {
  readonly page: Page;
  readonly #cdp: CDPSession;

  private constructor(page: Page, cdp: CDPSession) {
    this.page = page;
    this.#cdp = cdp;
  }

  static async join(person: Person): Promise<TouchedPhone> {
    await TouchedPhone.preparing(person);
    await person.page.goto('/devices/smart-device');
    return TouchedPhone.of(person);
  }

  /** From its next page on it cannot vibrate, as iPhones: it flashes. */
  static async preparing({ page }: Person): Promise<void> {
    await page.addInitScript(() => {
      Reflect.deleteProperty(Navigator.prototype, 'vibrate');
    });
  }

  /** A phone that has the page open. */
  static async of({ page, context }: Person): Promise<TouchedPhone> {
    await expect(page.getByRole('application', { name: 'Touch pad' })).toBeVisible();
    return new TouchedPhone(page, await context.newCDPSession(page));
  }

  /** Lays fingers on the pad, and leaves them there; each from 0 to 1 on both axes. */
  async touch(...fingers: readonly (readonly [number, number])[]): Promise<void> {
    const box = (await this.page.getByRole('application', { name: 'Touch pad' }).boundingBox())!;
    const touchPoints = fingers.map(([x, y], id) => ({
      x: box.x + x * box.width,
      y: box.y + y * box.height,
      id,
    }));
    await this.#cdp.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints });
  }

  async lift(): Promise<void> {
    await this.#cdp.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
  }

  async turn(alpha: number, beta: number, gamma: number): Promise<void> {
    const angles = { alpha, beta, gamma };
    await this.#cdp.send('DeviceOrientation.setDeviceOrientationOverride', angles);
  }

  get flash(): Locator {
    return this.page.locator('[data-flashing]');
  }
}
