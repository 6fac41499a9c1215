import type { Download, Locator, Page } from '@playwright/test';

/** The plot of a topic's page, or of a panel. */
export class PlotPage {
  readonly page: Page;
  readonly plot: Locator;
  readonly legend: Locator;
  readonly numbers: Locator;

  constructor(page: Page) {
    this.page = page;
    this.plot = page.getByRole('group', { name: /^Plot of / });
    this.legend = page.getByRole('list', { name: 'Lines' });
    this.numbers = page.getByRole('region', { name: 'Numbers' });
  }

  async open(topic: string): Promise<void> {
    await this.page.goto(`/topics/${encodeURIComponent(topic)}`);
  }

  /** The line in the legend: pressed while it is shown. */
  line(name: string): Locator {
    return this.legend.getByRole('button', { name: new RegExp(`^${name}\\b`) });
  }

  async chooseFor(line: string, action: string): Promise<void> {
    await this.legend.getByRole('button', { name: `Actions for ${line}`, exact: true }).click();
    await this.page.getByRole('menuitem', { name: action }).or(this.menuChoice(action)).click();
  }

  async choose(action: string): Promise<void> {
    await this.page.getByRole('button', { name: 'Save and axes' }).click();
    await this.page.getByRole('menuitem', { name: action }).click();
  }

  async save(action: string): Promise<Download> {
    const download = this.page.waitForEvent('download');
    await this.choose(action);
    return download;
  }

  async add(topic: string, number: string): Promise<void> {
    await this.page.getByRole('button', { name: 'Add series' }).click();
    await this.page.getByRole('combobox', { name: 'Search topics' }).fill(topic);
    await this.page.getByRole('option', { name: topic }).click();
    await this.page.getByRole('option').filter({ hasText: number }).click();
  }

  private menuChoice(name: string): Locator {
    return this.page.getByRole('menuitemradio', { name });
  }
}
