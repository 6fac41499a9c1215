import { expect, type Locator, type Page } from '@playwright/test';

/** The performance page: four tests and their results. */
export class PerformancePage {
  readonly page: Page;
  readonly places: Locator;
  readonly start: Locator;
  readonly stop: Locator;
  readonly progress: Locator;
  /** Stored results in the list. */
  readonly kept: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.places = page.getByRole('navigation', { name: 'Tests' });
    this.start = page.getByRole('button', { name: 'Start', exact: true });
    this.stop = page.getByRole('button', { name: 'Stop', exact: true });
    this.progress = page.getByRole('progressbar', { name: 'Progress of the test' });
    this.kept = page.getByRole('list', { name: 'Stored results' }).getByRole('listitem');
  }

  async open(place = 'round-trip'): Promise<void> {
    await this.page.goto(`/performance/${place}`);
  }

  async fill(fields: Readonly<Record<string, string>>): Promise<void> {
    for (const [name, value] of Object.entries(fields)) {
      await this.page.getByRole('textbox', { name, exact: true }).fill(value);
    }
  }

  /** Starts the test and waits until its result is shown. */
  async measure(): Promise<void> {
    await this.begin();
    await expect(this.start).toBeVisible({ timeout: 90_000 });
    await expect(this.page.getByRole('table', { name: 'Figures' })).toBeVisible();
  }

  /** Starts the test and waits until it has begun. */
  async begin(): Promise<void> {
    await expect(this.start).not.toHaveAttribute('aria-disabled', 'true');
    await this.start.click();
    await expect(this.stop).toBeVisible();
  }

  /** A number of the result as it is written. */
  figure(key: string): Locator {
    return this.page.locator(`[data-figure="${key}"] td`).first();
  }

  /** The number itself. */
  async figureValue(key: string): Promise<number> {
    const text = await this.figure(key).innerText();
    return Number(text.replace('−', '-').replace(/[^\d.-]/g, ''));
  }

  chart(title: string): Locator {
    return this.page.getByRole('figure', { name: title });
  }
}
