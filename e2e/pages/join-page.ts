import type { Locator, Page } from '@playwright/test';
import type { BrowserContextOptions } from '@playwright/test';

/**
 * Headers that make a caller on this computer a stranger, as a proxy for remote callers would. [AC-1] WebSockets carry
 * no such header, and are admitted by their credential.
 */
export const FROM_ELSEWHERE: BrowserContextOptions = {
  extraHTTPHeaders: { 'x-forwarded-for': '203.0.113.7' },
};

/** The join page, as on a phone. */
export class JoinPage {
  readonly page: Page;
  readonly heading: Locator;
  readonly name: Locator;
  readonly code: Locator;
  readonly join: Locator;
  /** What hinders this phone; absent while all is well. */
  readonly row: Locator;

  constructor({ page }: { readonly page: Page }) {
    this.page = page;
    this.heading = page.getByRole('heading', { level: 1 });
    this.name = page.getByLabel('Name', { exact: true });
    this.code = page.getByLabel('Code', { exact: true });
    this.join = page.getByRole('button', { name: 'Join', exact: true });
    this.row = page.locator('[data-join-row]');
  }

  /** All checks, behind the Details of the row. */
  async openChecks(): Promise<void> {
    await this.row.getByRole('button', { name: 'Details' }).click();
  }

  /** One measured fact, by its id of AC-30. */
  fact(id: 'master' | 'secure' | 'channel' | 'clock' | 'sensors'): Locator {
    return this.page.locator(`[data-check="${id}"]`);
  }

  /** Types a code, which is checked after its last character. */
  async type(code: string): Promise<void> {
    await this.code.fill('');
    await this.code.fill(code);
  }
}
