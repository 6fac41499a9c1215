import { expect, type Locator, type Page } from '@playwright/test';

const TOOLS: ReadonlySet<string> = new Set([
  'Publish',
  'Services',
  'Bridges',
  'Performance',
  'Studies',
]);

/** The shell around every page: navigation, connection, palette. */
export class Shell {
  readonly page: Page;
  readonly navigation: Locator;
  readonly connection: Locator;
  /** Under the top bar while the link is broken. */
  readonly disconnectedStrip: Locator;
  readonly main: Locator;
  readonly palette: Locator;

  constructor(page: Page) {
    this.page = page;
    this.navigation = page.getByRole('navigation', { name: 'Pages' }).filter({ visible: true });
    this.connection = page.getByRole('button', { name: /^Connection, / });
    this.disconnectedStrip = page
      .getByRole('alert')
      .filter({ has: page.getByRole('button', { name: /^(Retry now|Connect|Use this tab)$/ }) });
    this.main = page.getByRole('main');
    this.palette = page.getByRole('dialog').filter({ has: page.getByRole('combobox') });
  }

  /** Goes to a page by the navigation, of which the tools are folded. */
  async go(to: string): Promise<void> {
    const link = this.navigation.getByRole('link', { name: to, exact: true });
    const tools = this.navigation.getByRole('button', { name: 'Tools' });
    if (TOOLS.has(to) && (await tools.getAttribute('aria-expanded')) === 'false')
      await tools.click();
    await link.click();
  }

  /** Opens the command palette with the keyboard. */
  async openPalette(): Promise<void> {
    // A page that is still being made hears no keys.
    await this.main.waitFor();
    await this.page.keyboard.press('ControlOrMeta+k');
    await this.palette.waitFor();
  }

  /** A button of the top bar: on phones another one of the same name is shown. */
  button(name: string): Locator {
    return this.page.getByRole('banner').getByRole('button', { name }).filter({ visible: true });
  }

  /** Waits until the page is a client of the master and has measured the way to it. */
  async expectConnected(): Promise<void> {
    await expect(this.connection).toContainText(/\d\s*ms/);
  }

  /** Modules that run in this tab, as the numbers of the connection say. */
  async expectModulesHere(count: number): Promise<void> {
    await this.connection.click();
    const numbers = this.page.getByRole('dialog', { name: 'Connection' });
    await expect(numbers).toContainText(new RegExp(`Modules in this tab\\s*${count},`));
    await this.page.keyboard.press('Escape');
    await expect(numbers).toBeHidden();
  }

  /** Pixels that stick out to the right of the screen. */
  async overflowPx(): Promise<number> {
    return this.page.evaluate(
      () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    );
  }
}
