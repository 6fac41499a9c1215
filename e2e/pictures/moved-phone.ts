import { expect, type CDPSession, type Page } from '@playwright/test';
import type { Person } from '../fixtures/test.ts';

const SENSORS = ['accelerometer', 'linear-acceleration', 'gyroscope'] as const;
const GRAVITY = 9.81;

/** A person who holds the page of a smart device, moves it, and draws on its pad. */
export class MovedPhone {
  readonly page: Page;
  readonly #cdp: CDPSession;
  #step = 0;

  private constructor(page: Page, cdp: CDPSession) {
    this.page = page;
    this.#cdp = cdp;
  }

  static async open({ page, context }: Person): Promise<MovedPhone> {
    const cdp = await context.newCDPSession(page);
    for (const type of SENSORS) {
      await cdp.send('Emulation.setSensorOverrideEnabled', { enabled: true, type });
    }
    await page.goto('/devices/smart-device');
    await expect(page.getByRole('application', { name: 'Touch pad' })).toBeVisible();
    return new MovedPhone(page, cdp);
  }

  /** Goes on for so many steps, and leaves the finger where it is. */
  async move(steps: number): Promise<void> {
    const pad = (await this.page.getByRole('application', { name: 'Touch pad' }).boundingBox())!;
    for (const end = this.#step + steps; this.#step < end; this.#step += 1) {
      const angle = this.#step / 14;
      await this.#turn(angle);
      const x = pad.x + pad.width * (0.5 + 0.42 * Math.cos(angle));
      const y = pad.y + pad.height * (0.5 + 0.28 * Math.sin(2 * angle));
      await this.#cdp.send('Input.dispatchTouchEvent', {
        type: this.#step === 0 ? 'touchStart' : 'touchMove',
        touchPoints: [{ x, y, id: 0 }],
      });
      await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
    }
  }

  async #turn(angle: number): Promise<void> {
    const x = 2.4 * Math.sin(angle);
    const y = 1.6 * Math.cos(1.7 * angle);
    const readings = {
      accelerometer: { x, y, z: GRAVITY + 0.4 * Math.sin(3 * angle) },
      'linear-acceleration': { x, y, z: 0.4 * Math.sin(3 * angle) },
      gyroscope: { x: y / 2, y: x / 2, z: 0.3 * Math.cos(angle) },
    };
    for (const type of SENSORS) {
      const reading = { xyz: readings[type] };
      await this.#cdp.send('Emulation.setSensorOverrideReadings', { type, reading });
    }
    await this.#cdp.send('DeviceOrientation.setDeviceOrientationOverride', {
      alpha: 40 + 12 * Math.sin(angle),
      beta: 18 + 9 * Math.cos(angle),
      gamma: 6 * Math.sin(1.7 * angle),
    });
  }
}
