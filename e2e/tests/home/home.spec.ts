import { expect, test } from '../../fixtures/test.ts';

test('home tells what goes on, from the first visit on', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/');
  const sentence = page.getByRole('heading', { level: 1 });
  const here = page.getByRole('table', { name: 'Clients' });
  const intro = page.getByRole('region', { name: 'What Ubi-Interact does' });
  await expect(sentence).toContainText('Only this browser is connected.');
  await expect(here.getByRole('row', { name: /Anna/ })).toBeVisible();

  await test.step('home draws what the master takes', async () => {
    for (const name of ['Main-thread load', 'CPU load of the master', 'Event-loop delay']) {
      await expect(
        page.getByRole('img', { name: new RegExp(`^${name} over the last ten minutes: now \\d`) }),
      ).toBeVisible();
    }
  });

  await expect(intro.getByText('Ubi-Interact connects phones')).toBeVisible();
  await expect(intro.getByRole('img', { name: /module mirrors/ })).toBeVisible();
  const robot = await room.program('Robot');
  let value = 0;
  let beat: ReturnType<typeof setInterval> | undefined;

  await test.step('home describes clients and data flow in one sentence', async () => {
    await expect(sentence).toContainText('Two clients are connected');
    await expect(sentence).toContainText('none publishes data');
    beat = setInterval(() => robot.publish('/lab/beat', 'double', value++), 20);
    await expect(sentence).toContainText('data is flowing');
  });

  await test.step('home draws records per second and says them', async () => {
    await expect(
      page.getByRole('img', { name: /^Records per second over the last ten minutes: now [1-9]/ }),
    ).toBeVisible();
    clearInterval(beat);
  });

  await test.step('home explains the product with a picture until the first session exists', async () => {
    await expect(intro).toBeVisible();
    await robot.call('sessionRuntimeAdd', { name: 'First' });
    await expect(page.getByRole('list', { name: 'Sessions' })).toContainText('First');
    await expect(intro).toHaveCount(0);
  });

  const phone = (await room.withPhone('Ben')).page;
  await phone.goto('/');

  await test.step('home lists connected clients by name, as they join and leave', async () => {
    await expect(here.getByRole('row', { name: /Robot/ })).toBeVisible();
    await expect(here.getByRole('row', { name: /Ben/ })).toBeVisible();
    await robot.close();
    await expect(here.getByRole('row', { name: /Robot/ })).toHaveCount(0);
  });

  await test.step('the first screen of a phone is what it can do here', async () => {
    const start = phone.getByRole('region', { name: 'Use this device as' });
    await expect(start.getByRole('link', { name: /^Smart device/ })).toBeInViewport();
    await start.getByRole('link', { name: /^Controller/ }).tap();
    await expect(phone).toHaveURL(/\/devices\/controller$/);
  });

  await test.step('a name given in the settings is seen by others at once, and kept', async () => {
    await phone.goto('/settings');
    const name = phone.getByRole('textbox', { name: 'Name' });
    await name.fill('Benedict');
    await name.press('Enter');
    await expect(here.getByRole('row', { name: /Benedict/ })).toBeVisible();
    await phone.reload();
    await expect(name).toHaveValue('Benedict');
  });

  await test.step('from home the first example is one click away', async () => {
    await page
      .getByRole('region', { name: /^Examples/ })
      .getByRole('link', { name: /Mouse pointer/ })
      .click();
    await expect(page).toHaveURL(/\/examples\/mouse-pointer$/);
  });
});
