import type { Locator, Page } from '@playwright/test';

/** The library of modules, and the module that is selected. */
export class ModulesPage {
  readonly page: Page;
  readonly list: Locator;
  readonly search: Locator;
  readonly detail: Locator;
  readonly tabSwitch: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.list = page.getByRole('list', { name: 'Modules' });
    this.search = page.getByRole('searchbox', { name: /^Search modules/ });
    this.detail = page.getByRole('article', { name: /^Module / });
    this.tabSwitch = page.getByRole('switch', { name: /^Run modules in this tab/ });
  }

  async open(): Promise<void> {
    await this.page.goto('/modules');
  }

  link(name: string): Locator {
    return this.list.getByRole('link', { name, exact: true });
  }

  async choose(name: string, action: string): Promise<void> {
    await this.page.getByRole('button', { name: `More for ${name}`, exact: true }).click();
    await this.page.getByRole('menuitem', { name: action }).click();
  }

  /** Gives a file to the page as if it was chosen in the dialog of the system. */
  async importFile(name: string, text: string): Promise<void> {
    const [chooser] = await Promise.all([
      this.page.waitForEvent('filechooser'),
      this.page.getByRole('button', { name: 'Import' }).click(),
    ]);
    await chooser.setFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
  }
}
