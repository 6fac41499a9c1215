import { expect, type Locator, type Page } from '@playwright/test';

/** One record as a form and as JSON. */
export class PublishPage {
  readonly page: Page;
  readonly topic: Locator;
  readonly json: Locator;
  readonly form: Locator;
  readonly sent: Locator;

  constructor({ page }: { page: Page }) {
    this.page = page;
    this.topic = page.getByRole('textbox', { name: 'Topic', exact: true });
    this.json = page.getByRole('textbox', { name: 'Record as JSON' });
    this.form = page.getByRole('region', { name: 'Form' });
    this.sent = page.getByRole('status', { name: 'Sent' });
  }

  async open(topic?: string): Promise<void> {
    await this.page.goto(topic === undefined ? '/publish' : `/publish?topic=${topic}`);
  }

  async choose(format: string): Promise<void> {
    await this.page.getByRole('combobox', { name: 'Data format' }).click();
    await this.page.getByRole('option', { name: format, exact: true }).click();
  }

  async publish(): Promise<void> {
    await this.page.getByRole('button', { name: 'Publish', exact: true }).click();
  }

  /** The button is disabled for this reason. */
  async expectBlocked(reason: string | RegExp): Promise<void> {
    const button = this.page.getByRole('button', { name: 'Publish', exact: true });
    await expect(button).toHaveAttribute('aria-disabled', 'true');
    await expect(button).toHaveAttribute('aria-description', reason);
  }

  /** A field of the form by its label. */
  field(name: string): Locator {
    return this.form.getByRole('textbox', { name, exact: true });
  }
}
