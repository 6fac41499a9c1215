import type { Locator } from '@playwright/test';
import type { UbiiClient } from '@ubii/client-web';
import { expect, test } from '../../fixtures/test.ts';

/** One percent of the time is much to this master: what is noisy anywhere is noisy here. */
test.use({ masterStart: { flags: ['--busy-percent', '1', '--publisher-percent', '1'] } });

/** Publishes some thousand records per second until it is told to stop. */
function makeNoise(robot: UbiiClient): () => void {
  let value = 0;
  const noise = setInterval(() => {
    for (let i = 0; i < 40; i++) robot.publish(`/robot/joint_${i}`, 'double', value++);
  }, 10);
  return () => clearInterval(noise);
}

/** The row of a problem, which may be one of those that are counted only. */
async function find(row: Locator): Promise<Locator> {
  const more = row.page().getByRole('button', { name: /^and \d+ more$/ });
  await expect(row.or(more).first()).toBeVisible();
  if (await more.isVisible()) await more.click();
  return row;
}

test('home helps against what takes too much', async ({ room }) => {
  const robot = await room.program('Robot');
  const { page } = await room.atDesk('Anna');
  await page.goto('/');
  const rows = page.getByRole('list', { name: 'Problems' }).getByRole('listitem');

  await test.step('home names the client with too high a load, with cause and remedy; one press throttles, another lifts it [EX-31, EX-47]', async () => {
    const stop = makeNoise(robot);
    const noisy = await find(rows.filter({ hasText: /Robot publishes .* records per second/ }));
    await expect(noisy).toContainText('Publish less often');
    await expect(page.getByRole('img', { name: /over the last ten minutes/ })).toHaveCount(1);
    await expect(noisy.getByRole('link', { name: 'Open client' })).toHaveAttribute(
      'href',
      `/clients/${robot.id}`,
    );
    await noisy.getByRole('button', { name: 'Throttle' }).click();
    const throttled = await find(rows.filter({ hasText: /Robot is throttled/ }));
    await expect(throttled).toContainText('by Anna');
    await throttled.getByRole('button', { name: 'Remove throttle' }).click();
    await expect(throttled).toHaveCount(0);
    stop();
  });

  await test.step('home stops a session whose module takes too much, and starts it again [EX-47]', async () => {
    const { id } = await robot.call('sessionRuntimeAdd', {
      name: 'Slow one',
      processingModules: [
        {
          name: 'slow',
          processingMode: { frequency: { hertz: 20 } },
          onProcessingStringified:
            '() => { const start = Date.now(); while (Date.now() - start < 70); }',
        },
      ],
    });
    await robot.call('sessionRuntimeStart', { id });
    const slow = await find(rows.filter({ hasText: 'later than its mode requires' }));
    await expect(slow).toContainText('Lower its frequency');
    await slow.getByRole('button', { name: 'Stop session' }).click();
    const running = page.getByRole('region', { name: 'Running' });
    await expect(running).toContainText('Nothing runs.');
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(running.getByRole('link', { name: /Slow one/ })).toBeVisible();
  });
});

test('a throttled page shows actor, reason and remedy once, on every page [EX-33]', async ({
  room,
}) => {
  const { page } = await room.withPhone('Anna');
  await page.goto('/topics');
  const robot = await room.program('Robot');
  await expect
    .poll(async () => (await robot.call('clientGetList')).elements.map(({ name }) => name))
    .toContain('Anna');
  const { elements } = await robot.call('clientGetList');
  const targetId = elements.find(({ name }) => name === 'Anna')!.id;
  const throttle = (recordsPerSecond: number) =>
    robot.call('clientThrottle', { targetId, recordsPerSecond, reason: 'too loud' });

  await throttle(10);
  const warning = page.getByRole('status', { name: 'Warning' });
  await expect(warning).toContainText(/This page is throttled .* by Robot: too loud/);
  await expect(warning).toContainText('ask an admin to remove the throttle');
  await warning.getByRole('button', { name: 'Dismiss the warning' }).click();
  await expect(warning).toHaveCount(0);
  await page.getByRole('link', { name: 'Home' }).click();
  await expect(page.getByRole('list', { name: 'Problems' })).toContainText('throttled');
  await expect(warning).toHaveCount(0);

  await test.step('it is told again when it happens again', async () => {
    await throttle(0);
    await expect(page.getByRole('listitem').filter({ hasText: 'is throttled' })).toHaveCount(0);
    await throttle(20);
    await expect(warning).toContainText('throttled');
  });
});
