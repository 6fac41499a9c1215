import { expect, type Locator, type Page } from '@playwright/test';

/** One module being written. */
export class ModuleEditor {
  readonly page: Page;
  readonly code: Locator;
  readonly lines: Locator;
  readonly about: Locator;
  readonly tryIt: Locator;
  readonly versions: Locator;
  /** An earlier version beside the code, in place of the code. */
  readonly comparison: Locator;
  readonly save: Locator;
  readonly problems: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.code = page.getByRole('region', { name: 'Code', exact: true });
    this.lines = this.code.locator('.view-line');
    this.about = page.getByRole('region', { name: 'About the module' });
    this.tryIt = page.getByRole('region', { name: 'Try it' });
    this.versions = page.getByRole('region', { name: 'Versions' });
    this.comparison = page.getByRole('region', {
      name: /^Version \d+ and the code in the editor$/,
    });
    this.save = page.getByRole('button', { name: 'Save', exact: true });
    this.problems = page.getByRole('region', { name: 'Problems in the code' });
  }

  async open(name: string): Promise<void> {
    await this.page.goto(`/modules/${encodeURIComponent(name)}/edit`);
  }

  async create(template: string): Promise<void> {
    await this.page.goto('/modules');
    await this.page.getByRole('button', { name: 'New module', exact: true }).click();
    await this.page.getByRole('dialog').getByRole('button', { name: template }).click();
    await expect(this.about.getByLabel('Name', { exact: true })).not.toHaveValue('');
  }

  /** Clicks at the end of the line with this text, and writes there, all at once: each key costs a check of the code. */
  async typeAfter(text: string, typed: string): Promise<void> {
    await this.lines.filter({ hasText: text }).first().click();
    await this.page.keyboard.press('End');
    if (typed !== '') await this.page.keyboard.insertText(typed);
  }

  /** The text as it is shown; Monaco writes spaces that do not break. */
  async expectCode(text: string): Promise<void> {
    await expect
      .poll(async () => (await this.lines.allInnerTexts()).join('\n').replaceAll('\u00a0', ' '))
      .toContain(text);
  }

  async saveIt(): Promise<void> {
    await this.save.click();
    await expect(this.page.getByRole('status').filter({ hasText: /^Saved$/ })).toBeVisible();
  }

  input(name: string): Locator {
    return this.tryIt.getByRole('region', { name: `Input ${name}`, exact: true });
  }

  output(name: string): Locator {
    return this.tryIt.getByRole('region', { name: `Output ${name}`, exact: true });
  }

  async beside(view: 'Try it' | 'Versions'): Promise<void> {
    await this.page.getByRole('radio', { name: view }).click();
  }

  async step(): Promise<void> {
    await this.tryIt.getByRole('button', { name: 'Step' }).click();
  }
}
