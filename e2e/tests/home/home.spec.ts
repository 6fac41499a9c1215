import { expect, test } from '../../fixtures/test.ts';

test('home tells who comes back what goes on', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/');
  const sentence = page.getByRole('heading', { level: 1 });
  const here = page.getByRole('list', { name: 'Here' }).getByRole('listitem');
  const running = page.getByRole('region', { name: 'Running' });
  await expect(sentence).toContainText('Only this browser is connected.');
  await expect(here.filter({ hasText: 'Anna' })).toContainText('this browser');
  await expect(running).toContainText('Nothing runs.');
  const robot = await room.program('Robot');
  let value = 0;
  let beat: ReturnType<typeof setInterval> | undefined;

  await test.step('home describes clients and data flow in one sentence', async () => {
    await expect(sentence).toContainText('Two clients are connected');
    await expect(sentence).toContainText('none publishes data');
    beat = setInterval(() => robot.publish('/lab/beat', 'double', value++), 20);
    await expect(sentence).toContainText('data is flowing');
  });

  await test.step('home has no charts of the master; its settings draw what it takes and passes on', async () => {
    const ofLastMinutes = page.getByRole('img', { name: /over the last ten minutes: now \d/ });
    await expect(ofLastMinutes).toHaveCount(0);
    await page.goto('/settings/master');
    await expect(ofLastMinutes).toHaveCount(4);
    await expect(
      page.getByRole('img', { name: /^Records per second over the last ten minutes: now [1-9]/ }),
    ).toBeVisible();
    clearInterval(beat);
    await page.goto('/');
  });

  await test.step('what runs is a card, which a number opens', async () => {
    const { id } = await robot.call('sessionRuntimeStart', {
      name: 'First',
      processingModules: [{ name: 'clock' }],
    });
    const card = running.getByRole('link', { name: /First/ });
    await expect(card).toBeVisible();
    await expect(sentence).toContainText('One session runs for two clients.');
    await page.keyboard.press('1');
    await expect(page).toHaveURL(new RegExp(`/sessions/${id}`));
    await page.goBack();
    await expect(card).toBeVisible();
  });

  await test.step('what was opened last can be gone on with, and started again', async () => {
    const { elements } = await robot.call('sessionRuntimeGetList');
    await robot.call('sessionRuntimeStop', { id: elements[0]!.id });
    const opened = page.getByRole('list', { name: 'Continue' });
    await expect(opened.getByRole('link').first()).toContainText(/First\s*session, stopped/);
    await expect(opened).toContainText('Mouse pointer');
    await expect(running).toContainText('Nothing runs. Start First again?');
    await running.getByRole('button', { name: 'Start' }).click();
    await expect(running.getByRole('link', { name: /First/ })).toBeVisible();
    await expect(opened).not.toContainText('First');
  });

  const phone = (await room.withPhone('Ben')).page;
  await phone.goto('/');

  await test.step('home lists connected clients by name, as they join and leave', async () => {
    await expect(here.filter({ hasText: 'Robot' })).toBeVisible();
    await expect(here.filter({ hasText: 'Ben' })).toBeVisible();
    await robot.close();
    await expect(here.filter({ hasText: 'Robot' })).toHaveCount(0);
  });

  await test.step('the first screen of a phone has something to touch, and what runs', async () => {
    await expect(phone.getByRole('heading', { level: 1 })).toContainText('Your phone is in.');
    await phone.getByRole('application', { name: 'Touch pad' }).tap({ position: { x: 20, y: 20 } });
    await expect(phone.getByRole('link', { name: /First/ })).toBeVisible();
    await expect(phone.getByRole('link', { name: /other here/ })).toContainText('Anna');
    await phone.getByRole('link', { name: 'Open the whole device' }).tap();
    await expect(phone).toHaveURL(/\/devices\/smart-device$/);
  });

  await test.step('a name given in the settings is seen by others at once, and kept', async () => {
    await phone.goto('/settings');
    const name = phone.getByRole('textbox', { name: 'Name' });
    await name.fill('Benedict');
    await name.press('Enter');
    await expect(here.filter({ hasText: 'Benedict' })).toBeVisible();
    await phone.reload();
    await expect(name).toHaveValue('Benedict');
  });
});
