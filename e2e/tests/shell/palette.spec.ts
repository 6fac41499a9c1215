import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

test('the palette finds pages, settings and services', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  const shell = new Shell(page);
  await shell.expectConnected();

  await test.step('Escape closes the palette and gives the focus back', async () => {
    await shell.button('Connect a phone').focus();
    await shell.openPalette();
    await page.keyboard.press('Escape');
    await expect(shell.palette).toBeHidden();
    await expect(shell.button('Connect a phone')).toBeFocused();
  });

  await test.step('what is found nowhere is said', async () => {
    await shell.openPalette();
    await page.keyboard.type('qqqqqq');
    await expect(shell.palette.getByRole('option')).toHaveCount(0);
    await expect(shell.palette).toContainText('qqqqqq');
    await page.keyboard.press('Escape');
    await expect(shell.palette).toBeHidden();
  });

  await test.step('the palette finds pages of the settings, sessions to pause, services and modules', async () => {
    for (const [typed, found] of [
      ['limits', 'Settings, Limits'],
      ['/topic_list', 'topic_list'],
      ['start smooth a', 'Smooth a pointer'],
      ['diagnostics', 'Save diagnostics'],
      ['clock', 'clock'],
    ] as const) {
      await shell.openPalette();
      await page.keyboard.type(typed);
      await expect(shell.palette.getByRole('option').first()).toContainText(found);
      await page.keyboard.press('Escape');
      await expect(shell.palette).toBeHidden();
    }
  });

  await test.step('the palette finds a page by a few letters and goes there', async () => {
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
});
