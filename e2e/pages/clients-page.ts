import { expect, type Locator, type Page } from '@playwright/test';

/** The list of clients with their devices, the ranking of loads, and the client that is selected. */
export class ClientsPage {
  readonly page: Page;
  readonly list: Locator;
  readonly loads: Locator;
  readonly search: Locator;
  /** Note at the bottom about clients that left or came back. */
  readonly note: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.list = page.getByRole('treegrid', { name: 'Clients' });
    this.loads = page.getByRole('list', { name: 'Clients by load' });
    this.search = page.getByRole('searchbox', { name: /^Search clients/ });
    this.note = page.getByRole('contentinfo').or(page.locator('footer')).getByRole('status');
  }

  async open(address = ''): Promise<void> {
    await this.page.goto(`/clients${address}`);
  }

  /** A client, a device or a component, by its name. */
  row(name: string): Locator {
    return this.list.getByRole('row').filter({ has: this.page.getByRole('rowheader', { name }) });
  }

  /** The selected client. */
  detail(name: string): Locator {
    return this.page.getByRole('article', { name: `Client ${name}` });
  }

  /** A thing to do from the menu of a row. */
  async choose(name: string, action: string): Promise<void> {
    await this.row(name)
      .getByRole('button', { name: `More for ${name}` })
      .click();
    await this.page.getByRole('menuitem', { name: action }).click();
  }

  /** Names of the clients in the order in which they are shown. */
  async names(): Promise<string[]> {
    const labels = this.list.locator('[role="row"][aria-level="1"] .label');
    return labels.allTextContents();
  }

  dialog(name: RegExp): Locator {
    return this.page.getByRole('dialog', { name });
  }

  async expectConnected(): Promise<void> {
    await expect(this.page.getByRole('button', { name: /^Connection, / })).toContainText(/\d\s*ms/);
  }
}
