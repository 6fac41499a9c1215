import type { Page } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

const card = (page: Page, title: string) => page.getByRole('article', { name: title });

for (const screen of ['desktop', 'phone'] as const) {
  test(`an example session starts with one click on a ${screen}, and values flow`, async ({
    room,
  }) => {
    const { page } = screen === 'phone' ? await room.withPhone('Ines') : await room.atDesk('Anna');
    await page.goto('/examples');
    await expect(page.getByRole('article')).toHaveCount(12);
    const sine = card(page, 'Sine wave');

    await test.step('the preview runs the modules of the session', async () => {
      await expect(sine.locator('.label')).toContainText(/\d\.\d\d/);
    });

    await test.step('one click creates, starts and opens it', async () => {
      await sine.getByRole('button', { name: 'Start Sine wave' }).click();
      await expect(page).toHaveURL(/\/sessions\/[^/]+\/graph$/);
      await expect(page.getByText('Running').filter({ visible: true }).first()).toBeVisible();
      if (screen === 'desktop') {
        await expect(new GraphPage({ page }).node('Topic /examples/sine-wave/wave')).toContainText(
          /\d\.\d/,
        );
      }
    });

    await test.step('it is stopped and deleted where it was started, and there is one of it', async () => {
      await page.goto('/examples');
      await expect(sine).toContainText('Running');
      await sine.getByRole('button', { name: 'Open graph of Sine wave' }).click();
      await expect(page).toHaveURL(/\/graph$/);
      await page.goto('/examples');
      await sine.getByRole('button', { name: 'Stop Sine wave' }).click();
      await expect(sine.getByRole('button', { name: 'Start Sine wave' })).toBeVisible();
      await sine.getByRole('button', { name: 'Delete the session Sine wave' }).click();
      await expect(sine.getByRole('button', { name: /^Delete the session/ })).toBeHidden();
    });
  });
}
