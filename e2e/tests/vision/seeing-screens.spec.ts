import { expectAccessible, onPhone } from '../../fixtures/accessible.ts';
import { expect, test } from '../../fixtures/test.ts';
import { showPhoto } from '../../pages/picture-source.ts';
import { Shell } from '../../pages/shell.ts';

const PATH = '/examples/object-detection';

test('what is seen is accessible and fits a phone while it runs, also without a camera', async ({
  room,
}) => {
  test.slow();
  const { page } = await room.atDesk('Anna', { permissions: ['camera'], colorScheme: 'dark' });
  const camera = page.getByRole('radio', { name: 'Camera' });
  await page.goto(PATH);

  await test.step('a device without a camera shows the built-in clip, and says so', async () => {
    await camera.click();
    await expect(page.getByRole('status').filter({ hasText: 'no camera' })).toContainText(
      'The built-in clip is shown instead.',
    );
    await expect(page.getByRole('radio', { name: 'Built-in clip' })).toBeChecked();
    await expect(page.getByRole('button', { name: 'Start', exact: true })).toBeEnabled();
  });

  await test.step('a camera that is refused says how to allow it in this browser', async () => {
    // A browser without a window refuses the camera, as its prompt cannot be answered.
    await page.evaluate(() => {
      navigator.mediaDevices.getUserMedia = () =>
        Promise.reject(new DOMException('Permission denied', 'NotAllowedError'));
    });
    await camera.click();
    await expect(page.getByRole('alert')).toContainText('Camera access was denied.');
    await expect(page.getByRole('alert')).toContainText(
      'Click the icon left of the address, and turn Camera on.',
    );
  });

  await test.step('what is seen is accessible and fits a phone while it runs', async () => {
    await showPhoto(page, 'astronaut.jpg');
    await page.getByRole('button', { name: 'Start', exact: true }).click();
    await expect(page.getByRole('main')).toContainText(/Live| s old/);
    await page.getByRole('switch', { name: /^Body/ }).click();
    await expect(page.locator('[data-bone]').first()).toBeAttached();
    await expect(page.locator('[data-label]').first()).toBeAttached();
    const expectGood = async (): Promise<void> => {
      await expectAccessible(page);
      expect(await new Shell(page).overflowPx()).toBe(0);
    };
    await expectGood();
    await onPhone(page, expectGood);
  });
});
