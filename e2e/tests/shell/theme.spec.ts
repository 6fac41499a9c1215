import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

const BACKGROUND = { dark: 'rgb(9, 12, 11)', light: 'rgb(232, 234, 231)' };

test('the theme is that of the system or the one that was chosen', async ({ room }) => {
  const { page } = await room.atDesk(undefined, { colorScheme: 'dark' });
  const { navigation } = new Shell(page);

  for (const colorScheme of ['light', 'dark'] as const) {
    await test.step(`the theme follows the system: ${colorScheme}`, async () => {
      await page.emulateMedia({ colorScheme });
      await page.goto('/settings');
      await expect(navigation).toHaveCSS('background-color', BACKGROUND[colorScheme]);
    });
  }

  await test.step('a theme that was chosen stays, whatever the system says', async () => {
    await page.getByRole('radio', { name: 'Light' }).click();
    await expect(navigation).toHaveCSS('background-color', BACKGROUND.light);
    await page.reload();
    await expect(navigation).toHaveCSS('background-color', BACKGROUND.light);
    await page.getByRole('radio', { name: 'System' }).click();
    await expect(navigation).toHaveCSS('background-color', BACKGROUND.dark);
  });
});
