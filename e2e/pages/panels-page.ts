import type { Locator, Page } from '@playwright/test';

/** The page with several topics in panels. */
export class PanelsPage {
  readonly page: Page;
  readonly panels: Locator;
  readonly file: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.panels = page.getByRole('region', { name: /^Panel / });
    this.file = page.getByLabel('A layout from a file');
  }

  async open(): Promise<void> {
    await this.page.goto('/panels');
  }

  panel(topic: string): Locator {
    return this.page.getByRole('region', { name: `Panel ${topic}`, exact: true });
  }

  async add(topic: string): Promise<void> {
    await this.page.getByRole('button', { name: 'Add panel' }).click();
    await this.page.getByRole('combobox', { name: 'Search topics' }).fill(topic);
    await this.page.getByRole('option', { name: topic }).click();
    await this.panel(topic).waitFor();
  }

  /** Adds a control for a topic, which may not exist yet. */
  async addControl(kind: string, topic: string): Promise<void> {
    await this.page.getByRole('button', { name: 'Add panel' }).click();
    await this.page.getByRole('button', { name: 'Control for a new topic' }).click();
    await this.page.getByRole('radio', { name: kind }).click();
    await this.page.getByRole('textbox', { name: 'Topic' }).fill(topic);
    await this.page.getByRole('button', { name: 'Add control' }).click();
    await this.panel(topic).waitFor();
  }

  slider(topic: string): Locator {
    return this.panel(topic).getByRole('slider', { name: topic });
  }

  async choose(topic: string, action: string): Promise<void> {
    await this.page
      .getByRole('button', { name: `Actions for the panel ${topic}`, exact: true })
      .click();
    await this.page
      .getByRole('menuitem', { name: action, exact: true })
      .or(this.page.getByRole('menuitemradio', { name: action, exact: true }))
      .click();
  }

  async chooseLayout(action: string): Promise<void> {
    await this.page.getByRole('button', { name: /^Layouts, now/ }).click();
    await this.page
      .getByRole('menuitem', { name: action, exact: true })
      .or(this.page.getByRole('menuitemradio', { name: action, exact: true }))
      .click();
  }
}
