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
