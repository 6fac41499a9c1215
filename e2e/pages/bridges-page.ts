import type { Locator, Page } from '@playwright/test';

/** The bridges of a master, and the mappings of one of them. */
export class BridgesPage {
  readonly page: Page;
  readonly mappings: Locator;
  /** The form for a mapping. */
  readonly form: Locator;
  /** What the mapping in the form selects. */
  readonly preview: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.mappings = page.getByRole('list', { name: 'Mappings' });
    this.form = page.getByRole('dialog');
    this.preview = this.form.getByRole('region', { name: 'Preview' });
  }

  async open(): Promise<void> {
    await this.page.goto('/bridges');
  }

  bridge(name: string): Locator {
    return this.page.getByRole('article', { name: `Bridge ${name}` });
  }

  /** The button that opens a mapping. @param topic its pattern */
  mapping(topic: string): Locator {
    const row = this.mappings.getByRole('listitem').filter({ hasText: topic });
    return row.getByRole('button').first();
  }

  field(label: string): Locator {
    return this.form.getByLabel(label, { exact: true });
  }

  /** A thing to do from the menu of a mapping. */
  async choose(name: string, action: string): Promise<void> {
    await this.mappings.getByRole('button', { name: `More for ${name}` }).click();
    await this.page.getByRole('menuitem', { name: action }).click();
  }

  async undo(): Promise<void> {
    await this.page.getByRole('button', { name: 'Undo' }).click();
  }
}
