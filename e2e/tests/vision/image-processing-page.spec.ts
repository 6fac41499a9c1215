import { expect, test } from '../../fixtures/test.ts';
import { showPhoto } from '../../pages/picture-source.ts';

test('the example sends pictures through a module, shows what comes out, and changes it while it runs', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const { page } = await room.withPhone('Mara');
  await page.goto('/examples/image-processing');
  const outputs = page.getByRole('region', { name: 'Outputs' });
  await page.getByRole('button', { name: 'Start', exact: true }).tap();
  // The default output differs from the input.
  await expect(outputs).toContainText(' GRAY8,');
  await expect(page.getByRole('img', { name: 'The newest picture' })).toBeVisible();

  await test.step('a parameter applies while it runs', async () => {
    const format = page.getByRole('combobox', { name: 'format', exact: true });
    await format.selectOption('RGB8');
    await expect(outputs).toContainText(' RGB8,');
  });

  await test.step('what was wrong with one module is not told of the next', async () => {
    const left = page.getByRole('textbox', { name: 'x', exact: true });
    await left.fill('1');
    await left.press('Enter');
    await expect(page.getByRole('alert')).toContainText('is outside of the picture');
    await page.getByRole('combobox', { name: 'Module' }).tap();
    await page.getByRole('option', { name: /^picture-edges/ }).tap();
    await expect(outputs).toContainText(' GRAY8,');
    await expect(page.getByRole('alert')).toHaveCount(0);
  });

  await test.step('another module takes its place; what it finds is drawn over the picture', async () => {
    await page.getByRole('combobox', { name: 'Module' }).tap();
    await page.getByRole('option', { name: /^object-detection/ }).tap();
    await expect(page.locator('[data-shape="cup"]').first()).toBeAttached({ timeout: 40_000 });
    const { elements } = await robot.call('sessionRuntimeGetList');
    // Both modules use the same library, which is evaluated again for the second one.
    const backend = page.getByRole('link', { name: /^backend\b/ });
    await expect(outputs.getByRole('listitem').filter({ has: backend })).toContainText('wasm');
    expect(elements.map(({ processingModules: [module] }) => module!.name)).toEqual([
      'object-detection',
    ]);
  });

  await test.step('it ends with a press', async () => {
    await page.getByRole('button', { name: 'Stop', exact: true }).tap();
    await expect.poll(async () => (await robot.call('sessionRuntimeGetList')).elements).toEqual([]);
  });
});

test('at a desk, the page has room for pictures, outputs, and sources in which modules find something', async ({
  room,
}) => {
  const { page } = await room.atDesk('Ben');
  await page.goto('/examples/image-processing');
  await page.getByRole('button', { name: 'Start', exact: true }).click();

  await test.step('pictures and outputs fill the window of a desk without scrolling', async () => {
    const after = page.getByRole('img', { name: 'The newest picture' });
    await expect(after).toBeVisible();
    const stage = page.getByRole('figure').filter({ has: after }).first();
    const { width, height } = page.viewportSize()!;
    const box = (await stage.boundingBox())!;
    expect(box.width).toBeGreaterThan(width / 2);
    expect(box.height).toBeGreaterThan(height / 2);
    expect(box.y + box.height).toBeLessThanOrEqual(height);
    await expect(page.getByRole('region', { name: 'Outputs' })).toBeInViewport({ ratio: 1 });
  });

  await test.step('a module that finds nothing says so and offers sources in which it may', async () => {
    await showPhoto(page, 'chelsea.jpg');
    await page.getByRole('combobox', { name: 'Module' }).click();
    await page.getByRole('option', { name: /^hand-pose/ }).click();
    const hint = page.getByRole('status').filter({ hasText: 'hand-pose found nothing' });
    await expect(hint).toBeVisible({ timeout: 60_000 });
    await hint.getByRole('button', { name: 'Clip: Drawn hand' }).click();
    await expect(page.getByRole('combobox', { name: 'Built-in clip' })).toContainText('Drawn hand');
    const hands = page
      .getByRole('listitem')
      .filter({ has: page.getByRole('link', { name: 'hands' }) });
    await expect(hands).toContainText('1.00', { timeout: 30_000 });
    await expect(hint).toHaveCount(0);
  });
});
