import { countLoadedScripts } from '../../fixtures/loaded-scripts.ts';
import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

test('a new user touches a living session at once, and sees what to do next @smoke', async ({
  room,
}) => {
  const { page } = await room.atDesk();
  const robot = await room.program('Robot');
  const running = async (): Promise<string[]> =>
    (await robot.call('sessionRuntimeGetList')).elements.map(({ name }) => name);
  await page.goto('/');
  await expect(page.getByRole('heading', { level: 1 })).toHaveText(
    /^\s*Ubi-Interact connects phones/,
  );
  const living = page.getByRole('region', { name: 'Living session' });
  const node = living.getByRole('group', { name: 'Module Mirror' });
  const steps = page.getByRole('list', { name: 'Next steps' });

  await test.step('a session of the master mirrors the pointer', async () => {
    const pad = living.getByRole('application', { name: /^Your pointer/ });
    await expect(node).toContainText('Live');
    expect(await running()).toHaveLength(1);
    const { width, height } = (await pad.boundingBox())!;
    await pad.hover({ position: { x: width / 4, y: height / 2 } });
    await expect(living.getByRole('figure', { name: 'Your pointer' })).toContainText(/x 0\.25\d/);
    await expect(living.getByRole('figure', { name: 'The dot follows, mirrored' })).toContainText(
      /x 0\.7[45]\d/,
    );
  });

  await test.step('it ends with the page, and Home is new again until a session was opened', async () => {
    await new Shell(page).go('Topics');
    await expect.poll(running).toEqual([]);
    await new Shell(page).go('Home');
    await expect(node).toContainText('Live');
  });

  await test.step('the session is kept, and its graph is opened, to change what it does', async () => {
    await expect(steps.getByRole('listitem')).toHaveCount(3);
    await steps.getByRole('button', { name: /Change what it does/ }).click();
    await expect(page).toHaveURL(/\/sessions\/[^/]+/);
    await expect.poll(running).toEqual(['Mirror my pointer']);
  });

  await test.step('who has opened a session sees what runs, and finds the first one behind Learn', async () => {
    await new Shell(page).go('Home');
    await expect(page.getByRole('heading', { level: 1 })).toContainText('One session runs');
    await expect(page.getByRole('list', { name: 'Running' })).toContainText('Mirror my pointer');
    const left = page.getByRole('region', { name: 'Next steps' });
    await expect(left.getByRole('link', { name: 'Start an example' })).toBeVisible();
    await left.getByRole('button', { name: 'Use your phone' }).click();
    const connect = page.getByRole('dialog', { name: 'Connect a phone' });
    await expect(connect).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(connect).toBeHidden();
    await expect(left).not.toContainText('phone');
    await left.getByRole('button', { name: 'Dismiss' }).click();
    await expect(left).toBeHidden();
    await new Shell(page).go('Learn');
    await page.getByRole('link', { name: 'See a living session' }).click();
    await expect(living.getByRole('application', { name: /^Your pointer/ })).toBeVisible();
    await expect(page.getByRole('link', { name: 'Mirror my pointer' })).toBeVisible();
  });
});

test('a cold load of home takes less than 200 kB of JavaScript, headers included @smoke', async ({
  room,
}) => {
  const { page } = await room.atDeskForTheFirstTime();
  const bytes = await countLoadedScripts(page);
  await page.goto('/');
  await expect(page.getByRole('list', { name: 'Next steps' })).toBeVisible();
  await expect(page.getByRole('application', { name: /^Your pointer/ })).toBeVisible();
  await page.waitForLoadState('networkidle');
  expect(bytes()).toBeGreaterThan(100_000);
  expect(bytes()).toBeLessThan(200_000);
});
