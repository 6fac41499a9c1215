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

    await test.step('the preview runs the modules of the session where it is seen', async () => {
      await sine.scrollIntoViewIfNeeded();
      await expect(sine.locator('.label')).toContainText(/\d\.\d\d/);
    });

    await test.step('one click creates, starts and opens it', async () => {
      await sine.getByRole('button', { name: 'Start and open Sine wave' }).click();
      await expect(page).toHaveURL(/\/sessions\/[^/]+$/);
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
      await expect(page).toHaveURL(/\/sessions\/[^/]+$/);
      await page.goto('/examples');
      await sine.getByRole('button', { name: 'Stop Sine wave' }).click();
      await expect(sine.getByRole('button', { name: 'Start and open Sine wave' })).toBeVisible();
      await sine.getByRole('button', { name: 'Delete the session Sine wave' }).click();
      await expect(sine.getByRole('button', { name: /^Delete the session/ })).toBeHidden();
    });

    if (screen === 'phone') return;
    await test.step('keys go to the session that takes them, and to no shortcut of the page', async () => {
      await card(page, 'Keys to text')
        .getByRole('button', { name: 'Start and open Keys to text' })
        .click();
      const chord = new GraphPage({ page }).node('Topic /examples/key-chord/chord');
      await expect(chord).toBeVisible();
      await expect(page.getByText('Running').filter({ visible: true }).first()).toBeVisible();
      await page.keyboard.down('c');
      await expect(chord).toContainText('c');
      await page.keyboard.down('a');
      await expect(chord).toContainText(/a.*c|c.*a/);
      await expect(page.getByRole('dialog')).toHaveCount(0);
      await expect(page.getByRole('combobox')).toHaveCount(0);
      await page.keyboard.up('c');
      await page.keyboard.up('a');

      await test.step('with Ctrl, keys are still those of the page', async () => {
        await page.keyboard.press('Control+k');
        await expect(page.getByRole('combobox', { name: 'Search or run a command' })).toBeVisible();
      });
    });
  });
}
