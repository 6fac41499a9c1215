import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

const BACKGROUND = { dark: 'rgb(9, 12, 11)', light: 'rgb(232, 234, 231)' };

for (const colorScheme of ['dark', 'light'] as const) {
  test(`the theme follows the system: ${colorScheme}`, async ({ room }) => {
    const { page } = await room.atDesk(undefined, { colorScheme });
    await page.goto('/');
    await expect(new Shell(page).navigation).toHaveCSS('background-color', BACKGROUND[colorScheme]);
  });
}

test('a theme that was chosen stays, whatever the system says', async ({ room }) => {
  const { page } = await room.atDesk(undefined, { colorScheme: 'dark' });
  await page.goto('/settings');
  await page.getByRole('radio', { name: 'Light' }).click();
  const { navigation } = new Shell(page);
  await expect(navigation).toHaveCSS('background-color', BACKGROUND.light);
  await page.reload();
  await expect(navigation).toHaveCSS('background-color', BACKGROUND.light);
  await page.getByRole('radio', { name: 'System' }).click();
  await expect(navigation).toHaveCSS('background-color', BACKGROUND.dark);
});
