import { expect, type Locator, type Page } from '@playwright/test';
import { GraphPage } from './graph-page.ts';

/** A session as a whole: its graph, its run bar, and its drawers. */
export class SessionPage {
  readonly page: Page;
  readonly graph: GraphPage;
  readonly problems: Locator;
  readonly events: Locator;
  readonly text: Locator;
  readonly textProblems: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.graph = new GraphPage({ page });
    this.problems = page.getByRole('list', { name: 'Problems', exact: true });
    this.events = page.getByRole('list', { name: /^Events/ });
    this.text = page.getByRole('textbox', { name: 'Session as JSON' });
    this.textProblems = page.getByRole('list', { name: 'Problems of this text' });
  }

  tab(name: 'Log' | 'Statistics' | 'JSON'): Locator {
    return this.page
      .getByRole('group', { name: 'Drawers of the session' })
      .getByRole('button', { name, exact: true });
  }

  /** Opens a drawer, unless it is open. */
  async show(name: 'Log' | 'Statistics' | 'JSON'): Promise<void> {
    const tab = this.tab(name);
    await expect(tab).toBeVisible();
    if ((await tab.getAttribute('aria-expanded')) === 'false') await tab.click();
    await expect(tab).toHaveAttribute('aria-expanded', 'true');
  }

  /** Waits for a word about the life of the session. */
  async expectState(word: string): Promise<void> {
    await expect(this.graph.life).toContainText(word);
  }

  async act(action: 'Start' | 'Pause' | 'Resume' | 'Stop'): Promise<void> {
    await this.graph.life.getByRole('button', { name: action, exact: true }).click();
  }

  async choose(action: string): Promise<void> {
    await this.graph.choose(action);
  }

  /** The row of a module in the statistics. */
  module(name: string): Locator {
    return this.page
      .getByRole('row')
      .filter({ has: this.page.getByRole('button', { name, exact: true }) });
  }

  /** A number of a module as it is written in the statistics, such as `Runs/s`. */
  fact(moduleName: string, label: string): Locator {
    return this.module(moduleName).locator(`[data-figure="${label}"]`);
  }

  /** Chooses where a module runs. */
  async place(moduleName: string, where: RegExp): Promise<void> {
    await this.graph.life.getByRole('button', { name: /^Runs on / }).click();
    await this.page.getByRole('combobox', { name: `Where ${moduleName} runs` }).click();
    await this.page.getByRole('option', { name: where }).click();
    await this.page.keyboard.press('Escape');
    const apply = this.graph.life.getByRole('button', { name: 'Apply, 1 module restarts' });
    await apply.click();
    await expect(this.graph.life).toContainText('Applied');
  }

  /** Writes the text of a session and sends it off. */
  async write(text: string, button: 'Create' | 'Apply'): Promise<void> {
    await this.text.fill(text);
    await this.page.getByRole('button', { name: button, exact: true }).click();
  }
}
