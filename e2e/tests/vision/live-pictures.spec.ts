import type { UbiiClient } from '@ubii/client-web';
import { LAUNCH_WITH_CAMERA } from '../../fixtures/chromium.ts';
import type { Person } from '../../fixtures/person.ts';
import { expect, test } from '../../fixtures/test.ts';

test.use({ launchOptions: LAUNCH_WITH_CAMERA });

/** A radio link that takes a third of what the camera wants to send. */
const SLOW_BYTES_PER_SECOND = 800_000;
const CAMERA = { permissions: ['camera'] };

async function startCamera({ page }: Person): Promise<void> {
  await page.goto('/devices/camera');
  await page.getByRole('button', { name: 'Start the camera' }).tap();
  await expect(page.getByRole('button', { name: 'Stop the camera' })).toBeVisible();
}

const watchers = ({ page }: Person) =>
  page.getByRole('status', { name: 'Receivers of the pictures' });

/** Topics with a picture on the master, with its age in milliseconds. */
async function picturesOnMaster(program: UbiiClient): Promise<Map<string, number>> {
  const { elements, masterTimeMs } = await program.call('topicStatistics', { cursor: 0 });
  return new Map(
    elements
      .filter(({ topic, valueBytes }) => topic.endsWith('/camera_image') && valueBytes > 1000)
      .map(({ topic, publishedMs }) => [topic, masterTimeMs - publishedMs]),
  );
}

async function show({ page }: Person, state: 'hidden' | 'visible'): Promise<void> {
  await page.evaluate((now) => {
    Object.defineProperty(document, 'visibilityState', { value: now, configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  }, state);
}

test('a camera on a slow link sends smaller and fewer pictures, says why, and they stay new', async ({
  room,
}) => {
  const program = await room.program('viewer');
  const agesMs: number[] = [];
  const network = await room.network();
  const mara = await room.withPhoneOver(network, 'Mara', CAMERA);
  const { page } = mara;
  await startCamera(mara);
  program
    .subscribe({ glob: '/*/CameraWebInterface/camera_image' })
    .onRecord(({ timestampMs }) => agesMs.push(program.masterTime.nowMs() - timestampMs!));
  await expect.poll(() => agesMs.length).toBeGreaterThan(10);
  await expect(page.getByText(/because/)).toBeHidden();

  network.limit(SLOW_BYTES_PER_SECOND);
  await expect(page.getByText(/^320 → \d+ px.*, because \d+ kB\/s reach the master/)).toBeVisible({
    timeout: 60_000,
  });
  // Smaller still, until pictures are young again: no queue of old ones is on the way.
  await expect
    .poll(
      () => {
        const late = agesMs.splice(0);
        return late.length < 3 ? Infinity : Math.max(...late);
      },
      { timeout: 60_000, intervals: [3000] },
    )
    .toBeLessThan(1000);

  await page.getByRole('switch', { name: 'Adapt to connection and modules' }).tap();
  await expect(page.getByText(/because/)).toBeHidden();
  await expect(page.getByRole('radio', { name: '320' })).toBeChecked();
});

test('pictures of two cameras are seen by who is named, and none is left when they end [TD-49]', async ({
  room,
}) => {
  const program = await room.program('robot');
  const [mara, tom] = await Promise.all([
    room.withPhone('Mara', CAMERA),
    room.withPhone('Tom', CAMERA),
  ]);
  for (const phone of [mara, tom]) await startCamera(phone);
  await expect(watchers(mara)).toContainText('No other client receives these pictures.');
  await expect.poll(async () => (await picturesOnMaster(program)).size).toBe(2);

  await test.step('a session of each looks at its own pictures, on the master', async () => {
    for (const phone of [mara, tom]) {
      await phone.page.getByRole('radio', { name: 'On the host' }).tap();
      await expect(phone.page.getByText(/^\d+ objects? found\.$/)).toBeVisible();
      await expect(watchers(phone)).toContainText('The master receives these pictures.');
    }
    await expect(watchers(tom)).toContainText(
      'object-detection of “Objects in the pictures of Tom”, on the master',
    );
    // One session is enough for what follows.
    await tom.page.getByRole('radio', { name: 'Off' }).tap();
    await expect(watchers(tom)).toContainText('No other client receives these pictures.');
  });

  await test.step('a client that shows a picture is named on the phone that sends it', async () => {
    const anna = await room.atDesk('Anna');
    const [topic] = await topicsOf(program, 'Mara');
    await anna.page.goto(`/topics/${encodeURIComponent(topic!)}`);
    await expect(anna.page.locator('canvas').first()).toBeVisible();
    await expect(watchers(mara)).toContainText(
      /(The master and Anna|Anna and the master) receive/i,
    );
    await anna.page.goto('/settings');
    await expect(watchers(mara)).toContainText('The master receives these pictures.');
  });

  await test.step('nothing is left a second after a camera stops, or its page is hidden', async () => {
    await mara.page.getByRole('button', { name: 'Stop the camera' }).tap();
    await show(tom, 'hidden');
    await expect(watchers(mara)).toBeHidden();
    await expect
      .poll(async () => (await picturesOnMaster(program)).size, { timeout: 1000 })
      .toBe(0);
    await show(tom, 'visible');
    await expect.poll(async () => (await picturesOnMaster(program)).size).toBe(1);
  });

  await test.step('asked for, the newest one stays until the page is closed', async () => {
    const keep = mara.page.getByRole('switch', { name: /^Keep the newest picture/ });
    await keep.tap();
    await mara.page.getByRole('button', { name: 'Start the camera' }).tap();
    await expect.poll(async () => (await picturesOnMaster(program)).size).toBe(2);
    await mara.page.getByRole('button', { name: 'Stop the camera' }).tap();
    await expect(mara.page.getByText('Start it to publish pictures')).toBeVisible();
    await expect
      .poll(async () => Math.max(...(await picturesOnMaster(program)).values()))
      .toBeGreaterThan(2000);
    expect((await picturesOnMaster(program)).size).toBe(2);
    await mara.page.close();
    await expect
      .poll(async () => (await picturesOnMaster(program)).size, { timeout: 1000 })
      .toBe(1);
  });
});

async function topicsOf(program: UbiiClient, name: string): Promise<string[]> {
  const { elements } = await program.call('clientGetList');
  const ids = elements.filter((client) => client.name === name).map(({ id }) => id);
  const pictures = await picturesOnMaster(program);
  return [...pictures.keys()].filter((topic) => ids.some((id) => topic.startsWith(`/${id}/`)));
}
