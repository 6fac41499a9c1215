import { expect, type Locator, type Page } from '@playwright/test';

/** One session, and the text of one. */
export class SessionPage {
  readonly page: Page;
  readonly heading: Locator;
  readonly problems: Locator;
  readonly events: Locator;
  readonly text: Locator;
  readonly textProblems: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.heading = page.getByRole('heading', { level: 1 });
    this.problems = page.getByRole('list', { name: 'Problems', exact: true });
    this.events = page.getByRole('list', { name: /^Events/ });
    this.text = page.getByRole('textbox', { name: 'Session as JSON' });
    this.textProblems = page.getByRole('list', { name: 'Problems of this text' });
  }

  /** Waits for a word about the life of the session. */
  async expectState(word: string): Promise<void> {
    await expect(this.page.locator('.title')).toContainText(word);
  }

  async act(action: 'Start' | 'Pause' | 'Resume' | 'Stop' | 'Restart'): Promise<void> {
    await this.page.getByRole('button', { name: action, exact: true }).click();
  }

  async choose(action: string): Promise<void> {
    await this.page.getByRole('button', { name: 'More actions' }).click();
    await this.page.getByRole('menuitem', { name: action }).click();
  }

  module(name: string): Locator {
    return this.page.getByRole('article', { name: `Module ${name}`, exact: true });
  }

  /** A number of a module as it is written, such as `Runs/s`. */
  fact(moduleName: string, label: string): Locator {
    return this.module(moduleName)
      .locator('dl > div')
      .filter({ has: this.page.getByText(label, { exact: true }) })
      .locator('dd');
  }

  /** Chooses where a module runs. */
  async place(moduleName: string, where: RegExp): Promise<void> {
    // A tooltip stays as long as the pointer is on it, over what is to be clicked
    await this.page.mouse.move(0, 0);
    await this.page.getByRole('combobox', { name: `Where ${moduleName} runs` }).click();
    await this.page.getByRole('option', { name: where }).click();
  }

  /** Writes the text of a session and sends it off. */
  async write(text: string, button: 'Create' | 'Save'): Promise<void> {
    await this.text.fill(text);
    await this.page.getByRole('button', { name: button, exact: true }).click();
  }
}
