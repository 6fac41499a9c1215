import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

test('the palette finds a page by a few letters and goes there', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  const shell = new Shell(page);
  await shell.openPalette();
  // Not 0 ms long: a layer that waits for the end of an animation could stay open.
  await expect(shell.palette).toHaveCSS('animation-name', 'none');
  // All commands are listed, more than fit: the field keeps its height.
  const field = await shell.palette.locator('label').boundingBox();
  expect(field!.height).toBeGreaterThan(43.5);
  await page.keyboard.type('mouse');
  await expect(shell.palette.getByRole('option').first()).toContainText('Mouse pointer');
  await page.keyboard.press('Enter');
  await expect(page).toHaveURL(/\/examples\/mouse-pointer$/);
  await expect(shell.palette).toBeHidden();
});

test('Escape closes the palette and gives the focus back', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  const shell = new Shell(page);
  await shell.button('Connect a phone').focus();
  await shell.openPalette();
  await page.keyboard.press('Escape');
  await expect(shell.palette).toBeHidden();
  await expect(shell.button('Connect a phone')).toBeFocused();
});

test('what is found nowhere is said', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  const shell = new Shell(page);
  await shell.openPalette();
  await page.keyboard.type('qqqqqq');
  await expect(shell.palette.getByRole('option')).toHaveCount(0);
  await expect(shell.palette).toContainText('qqqqqq');
});
