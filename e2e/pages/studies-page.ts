import type { Locator, Page } from '@playwright/test';

/** The studies of the master, and the one that is opened. */
export class StudiesPage {
  readonly page: Page;
  readonly checks: Locator;
  readonly blocks: Locator;
  readonly participants: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.checks = page.getByRole('list', { name: 'Required devices' });
    this.blocks = page.getByRole('list', { name: 'Blocks' }).locator(':scope > li');
    this.participants = page.getByRole('list', { name: 'Participants' }).locator(':scope > li');
  }

  async open(): Promise<void> {
    await this.page.goto('/studies');
  }

  /** Opens a part of the study. */
  async openPart(name: 'Design' | 'Run' | 'Participants'): Promise<void> {
    await this.page
      .getByRole('navigation', { name: 'Parts of the study' })
      .getByRole('link', { name })
      .click();
  }

  button(name: string): Locator {
    return this.page.getByRole('button', { name, exact: true });
  }
}
