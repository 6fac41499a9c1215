import { expect, type Locator, type Page } from '@playwright/test';

/** The list of sessions. */
export class SessionsPage {
  readonly page: Page;
  readonly list: Locator;
  readonly search: Locator;
  readonly newSession: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.list = page.getByRole('list', { name: 'Sessions', exact: true });
    this.search = page.getByRole('searchbox', { name: /^Search sessions/ });
    this.newSession = page.getByRole('link', { name: 'New session' });
  }

  async open(): Promise<void> {
    await this.page.goto('/sessions');
  }

  /** Starts an example from the list of examples, which is where there are no sessions. */
  async startExample(name: string): Promise<void> {
    await this.page.getByRole('button', { name: `Start ${name}`, exact: true }).click();
    await expect(this.page).toHaveURL(/\/sessions\/[^/]+$/);
    await expect(this.page.getByRole('button', { name: `${name}, rename` })).toBeVisible();
  }

  row(name: string): Locator {
    return this.list
      .getByRole('listitem')
      .filter({ has: this.page.getByText(name, { exact: true }) });
  }

  link(name: string): Locator {
    return this.list.getByRole('link', { name, exact: true });
  }

  /** Chooses what can be done with a session beside the next thing. */
  async choose(name: string, action: string): Promise<void> {
    await this.page.getByRole('button', { name: `More for ${name}`, exact: true }).click();
    await this.page.getByRole('menuitem', { name: action }).click();
  }

  /** Drops a file on the list, as from the desktop of the system. */
  async dropFile(name: string, text: string): Promise<void> {
    const files = await this.page.evaluateHandle(
      ([fileName, content]) => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([content], fileName, { type: 'application/json' }));
        return transfer;
      },
      [name, text] as const,
    );
    await this.list.dispatchEvent('dragenter', { dataTransfer: files });
    await expect(this.page.getByText('Drop to import')).toBeVisible();
    await this.list.dispatchEvent('drop', { dataTransfer: files });
  }

  /** Gives files to the page as if they were chosen in the dialog of the system. */
  async importFiles(files: readonly { name: string; text: string }[]): Promise<void> {
    const [chooser] = await Promise.all([
      this.page.waitForEvent('filechooser'),
      this.page.getByRole('button', { name: 'Import' }).click(),
    ]);
    await chooser.setFiles(
      files.map(({ name, text }) => ({
        name,
        mimeType: 'application/json',
        buffer: Buffer.from(text),
      })),
    );
  }
}
