import { LAUNCH_WITH_CAMERA } from '../../fixtures/chromium.ts';
import { expect, test } from '../../fixtures/test.ts';

test.use({ launchOptions: LAUNCH_WITH_CAMERA });

test('a camera has its objects detected on the phone itself or on the master, in a session of its own', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const { page } = await room.withPhone('Mara', { permissions: ['camera'] });
  await page.goto('/devices/camera');
  await page.getByRole('button', { name: 'Start the camera' }).tap();
  // The picture pushes down what stands below it, once it is there.
  await expect(page.getByText(/\d [kM]B\/s/)).toBeVisible();
  const running = async (): Promise<string[]> =>
    (await robot.call('sessionRuntimeGetList')).elements.map(({ name }) => name);
  const found = page.getByText(/^\d+ objects? found\.$/);

  await page.getByRole('radio', { name: 'On this device' }).tap();
  await expect(found).toBeVisible();
  expect(await running()).toEqual(['Objects in the pictures of Mara']);
  await page.getByRole('radio', { name: 'On the host' }).tap();
  const nodeOf = async (): Promise<string | undefined> =>
    (await robot.call('sessionRuntimeGetList')).elements[0]?.processingModules[0]?.nodeId;
  const { id: masterId } = await robot.call('serverConfiguration');
  await expect.poll(nodeOf).toBe(masterId);
  await expect(found).toBeVisible();
  await expect(page.getByRole('link', { name: 'Open the session' })).toBeVisible();

  await page.getByRole('radio', { name: 'Off' }).tap();
  await expect.poll(running).toEqual([]);
});
