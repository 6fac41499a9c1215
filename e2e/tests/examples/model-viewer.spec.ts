import type { Page } from '@playwright/test';
import { LAUNCH_WITH_SENSORS } from '../../fixtures/chromium.ts';
import { expect, test } from '../../fixtures/test.ts';
import { TouchedPhone } from '../../pages/gatherer-page.ts';

test.use({ launchOptions: LAUNCH_WITH_SENSORS });

/** Rotation of the model as drawn by the scene: x, y, z, w. */
async function drawnTurn(page: Page): Promise<number[]> {
  const text = await page.locator('canvas').getAttribute('data-turn');
  return (text ?? '').split(' ').map(Number);
}

/** Turns are the same with all signs changed. */
async function expectTurn(page: Page, wanted: readonly number[]): Promise<void> {
  const distance = async () => {
    const drawn = await drawnTurn(page);
    return 1 - Math.abs(wanted.reduce((sum, part, index) => sum + part * (drawn[index] ?? NaN), 0));
  };
  await expect.poll(distance, { message: `turned by ${wanted.join(' ')}` }).toBeLessThan(1e-3);
}
const HALF = Math.SQRT1_2;

test('the model is turned by phones and hands', async ({ room }) => {
  test.slow();
  const { page } = await room.atDesk('Stage');
  await page.goto('/examples/model-viewer');
  const other = await room.atDesk('Balcony');

  await test.step('a hand stands in for a phone, and others can follow it', async () => {
    const model = page.getByRole('group', { name: 'Model' });
    await expect.poll(() => drawnTurn(page)).toHaveLength(4);
    await page.getByRole('button', { name: 'Reset rotation' }).click();
    await expectTurn(page, [0, 0, 0, 1]);
    await model.focus();
    for (let press = 0; press < 12; press++) await page.keyboard.press('ArrowRight');
    await expectTurn(page, [0, HALF, 0, HALF]);

    await other.page.goto('/examples/model-viewer');
    await other.page.getByRole('combobox', { name: 'Source of the rotation' }).click();
    await other.page.getByRole('option', { name: /Stage/ }).click();
    await expectTurn(other.page, [0, HALF, 0, HALF]);
  });

  await test.step('a phone turns the model for all who look, from where it is zeroed, and smoothed', async () => {
    await expect(page.getByText('Drag to rotate the model, or connect a phone')).toBeVisible();

    const phone = await TouchedPhone.join(await room.withPhone('Anna'));
    // Its page may not listen yet, and the same turn again is no event.
    await expect(async () => {
      await phone.turn(0, 89, 0);
      await phone.turn(0, 90, 0);
      await expect(page.getByText('Rotated by Anna.')).toBeVisible({ timeout: 2000 });
    }).toPass();
    await expectTurn(page, [0, 0, 0, 1]);
    await phone.turn(90, 0, 0);
    // Flat on the table, a quarter to the left
    await expectTurn(page, [-0.5, 0.5, 0.5, 0.5]);

    await other.page.goto('/examples/model-viewer');
    await expectTurn(other.page, [-0.5, 0.5, 0.5, 0.5]);

    await page.getByRole('button', { name: 'Set as straight direction' }).click();
    await expectTurn(page, [0, 0, 0, 1]);
    await phone.turn(180, 0, 0);
    await expectTurn(page, [0, 0, HALF, HALF]);
    await expectTurn(other.page, [0, HALF, HALF, 0]);

    await page.getByRole('switch', { name: /^Smooth with a session/ }).click();
    await expect(page.getByRole('link', { name: 'Open session' })).toBeVisible();
    await expect(other.page.getByRole('switch', { name: /^Smooth with a session/ })).toBeChecked();
    for (let beta = 1; beta <= 3; beta++) await phone.turn(180, beta, 0);
    await phone.turn(180, 0, 0);
    await expectTurn(page, [0, 0, HALF, HALF]);
  });

  await test.step('without WebGL words and numbers take the place of the picture', async () => {
    await page.addInitScript(() => {
      HTMLCanvasElement.prototype.getContext = () => null;
    });
    await page.goto('/examples/model-viewer');
    await expect(page.getByText('This browser does not support WebGL')).toBeVisible();
  });
});
