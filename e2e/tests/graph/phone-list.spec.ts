import { expect, test } from '../../fixtures/test.ts';

test('a phone wires its own touch in the list, and sees it arrive', async ({ room }) => {
  const other = await room.withPhone('Ben');
  await other.page.goto('/devices/smart-device');
  await other.page.getByRole('application').first().tap();
  const { page } = await room.withPhone('Ines');
  await page.goto('/sessions/new');
  const next = page.getByText(/^Next: /);
  const toast = page.getByText(/^(Added|Connected) /);
  const list = page.getByRole('list', { name: 'Nodes of the graph' });
  const input = list.getByRole('button', { name: /^Input pointer/ });

  await test.step('the list says what comes next', async () => {
    await page.getByRole('button', { name: 'Add', exact: true }).tap();
    await page.getByRole('combobox', { name: 'Add to the session' }).fill('mirror-pointer');
    await page
      .getByRole('option', { name: /mirror-pointer/ })
      .first()
      .tap();
    await expect(next).toHaveText(/press the input “pointer” of mirror-pointer/);
  });

  await test.step('topics of this phone come first, and a sheet has no message over it', async () => {
    await expect(toast).toHaveText('Added mirror-pointer');
    await input.tap();
    await expect(toast).toBeHidden();
    const first = page.getByRole('option').first();
    await expect(first).toContainText('touch_position');
    await expect(first).toContainText('this phone');
    await first.tap();
    await expect(toast).toHaveText('Connected touch_position to mirror-pointer · pointer');
  });

  await test.step('a switch is as large as a finger', async () => {
    await list.getByRole('button', { name: /^Input mirrorX/ }).tap();
    const { height, width } = (await page
      .getByRole('switch', { name: 'Value of mirrorX' })
      .boundingBox())!;
    expect(Math.min(height, width)).toBeGreaterThanOrEqual(44);
    await page.getByRole('button', { name: 'Close' }).tap();
  });

  await test.step('the pad opens with the session, and the touch arrives', async () => {
    await page.getByRole('button', { name: /Save and start/ }).tap();
    await expect(page.getByRole('button', { name: 'Close the pad' })).toBeVisible();
    await expect(input).toContainText('not touched');
    await page.getByRole('application').tap();
    await expect(input).toContainText(/0\.\d/);
    await page.getByRole('button', { name: 'Close the pad' }).tap();
    await expect(page.getByRole('application')).toBeHidden();
  });
});
