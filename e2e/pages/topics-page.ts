import type { Locator, Page } from '@playwright/test';

/** The tree of topics, and the topic that is selected. */
export class TopicsPage {
  readonly page: Page;
  readonly tree: Locator;
  readonly search: Locator;
  readonly detail: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.tree = page.getByRole('treegrid', { name: 'Topics' });
    this.search = page.getByRole('searchbox', { name: /^Search topics/ });
    this.detail = page.getByRole('article', { name: /^Topic / });
  }

  async open(): Promise<void> {
    await this.page.goto('/topics');
  }

  /** Unfolds every branch. */
  async expandAll(): Promise<void> {
    await this.page.getByRole('button', { name: 'Order and actions' }).click();
    await this.page.getByRole('menuitem', { name: 'Expand all' }).click();
  }

  /** The row of a branch or a topic by the last part of its path. */
  row(name: string): Locator {
    return this.tree.getByRole('row').filter({ has: this.page.getByRole('rowheader', { name }) });
  }

  /** The row's newest value. */
  value(name: string): Locator {
    return this.row(name).getByRole('gridcell').nth(0);
  }

  /** The row's records per second. */
  rate(name: string): Locator {
    return this.row(name).getByRole('gridcell').nth(1);
  }
}
