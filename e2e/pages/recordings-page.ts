import { expect, type Locator, type Page } from '@playwright/test';

/** The flight recorder, the list of recordings, and the one that is opened. */
export class RecordingsPage {
  readonly page: Page;
  /** Keeps what the flight recorder holds. */
  readonly keep: Locator;
  readonly rows: Locator;
  readonly running: Locator;
  readonly timeline: Locator;
  readonly graph: Locator;
  readonly inspector: Locator;
  readonly markers: Locator;
  /** Says that records of the opened recording go into live topics. */
  readonly liveBanner: Locator;
  /** How today's modules compare. */
  readonly comparison: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.keep = page.getByRole('button', { name: /^Keep the last/ });
    this.rows = page.getByRole('list', { name: 'Recordings' }).getByRole('listitem');
    this.running = page.getByRole('article', { name: /^Running recording / });
    this.timeline = page.getByRole('region', { name: 'Timeline' });
    this.graph = page.getByRole('region', { name: 'Recorded graph' });
    this.inspector = page.getByRole('region', { name: 'Selected track' });
    this.liveBanner = page.getByRole('status', { name: 'Live topics' });
    this.comparison = page.getByRole('region', { name: 'Today’s modules' });
    this.markers = this.timeline.getByRole('button', { name: /^Marker / });
  }

  async open(): Promise<void> {
    await this.page.goto('/recordings');
  }

  row(name: string): Locator {
    return this.rows.filter({ hasText: name });
  }

  /** Starts a recording of everything. */
  async record(name: string): Promise<void> {
    await this.button('Record').click();
    const dialog = this.page.getByRole('dialog', { name: 'Record' });
    await dialog.getByLabel('Name').fill(name);
    await dialog.getByRole('button', { name: 'Record' }).click();
    await this.running.waitFor();
  }

  /** Waits until the running recording has so many records. */
  async expectRecords(count: number): Promise<void> {
    const records = this.running.getByRole('definition').first();
    await expect
      .poll(async () => Number(await records.textContent()))
      .toBeGreaterThanOrEqual(count);
  }

  /** Chooses where records go that are played. */
  async playInto(target: 'This page only' | 'Live topics'): Promise<void> {
    await this.page.getByRole('radio', { name: target }).click();
  }

  /** The head of a track, with its value at the playhead. */
  track(topic: string): Locator {
    return this.timeline.getByRole('button').filter({ hasText: topic });
  }

  button(name: string): Locator {
    return this.page.getByRole('button', { name, exact: true });
  }
}
