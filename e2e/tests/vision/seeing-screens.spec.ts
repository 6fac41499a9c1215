import { expectAccessible } from '../../fixtures/accessible.ts';
import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

const PATH = '/examples/object-detection';

test('a device without a camera shows the built-in clip, and says so', async ({ room }) => {
  const { page } = await room.atDesk('Anna', { permissions: ['camera'] });
  await page.goto(PATH);
  await page.getByRole('radio', { name: 'Camera' }).click();
  await expect(page.getByRole('status').filter({ hasText: 'no camera' })).toContainText(
    'The built-in clip is shown instead.',
  );
  await expect(page.getByRole('radio', { name: 'Built-in clip' })).toBeChecked();
  await expect(page.getByRole('button', { name: 'Start', exact: true })).toBeEnabled();
});

test('a camera that is refused says how to allow it in this browser', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  await page.goto(PATH);
  // A browser without a window refuses the camera, as its prompt cannot be answered.
  await page.evaluate(() => {
    navigator.mediaDevices.getUserMedia = () =>
      Promise.reject(new DOMException('Permission denied', 'NotAllowedError'));
  });
  await page.getByRole('radio', { name: 'Camera' }).click();
  await expect(page.getByRole('alert')).toContainText('Camera access was denied.');
  await expect(page.getByRole('alert')).toContainText(
    'Click the icon left of the address, and turn Camera on.',
  );
});

test('what is seen is accessible and fits a phone while it runs', async ({ room }) => {
  test.slow();
  const options = { colorScheme: 'dark', reducedMotion: 'reduce' } as const;
  for (const person of [await room.atDesk('Anna', options), await room.withPhone('Ben', options)]) {
    const { page } = person;
    await page.goto(PATH);
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    await expect(page.getByRole('main')).toContainText(/Live| s old/);
    await page.getByRole('switch', { name: /^Body/ }).click();
    await expect(page.locator('[data-label]').first()).toBeAttached();
    await expectAccessible(page);
    expect(await new Shell(page).overflowPx()).toBe(0);
    await page.goto('/examples');
  }
});
