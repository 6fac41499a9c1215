import { expect, test } from '../../fixtures/test.ts';

test('home describes clients and data flow in one sentence', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/');
  const sentence = page.getByRole('heading', { level: 1 });
  await expect(sentence).toContainText('Only this browser is connected.');

  const robot = await room.program('Robot');
  await expect(sentence).toContainText('Two clients are connected');
  await expect(sentence).toContainText('none publishes data');

  let value = 0;
  const beat = setInterval(() => robot.publish('/lab/beat', 'double', value++), 20);
  await expect(sentence).toContainText('data is flowing');
  clearInterval(beat);
});

test('home lists connected clients by name, as they join and leave', async ({ room }) => {
  const { page } = await room.atDesk('Anna');
  await page.goto('/');
  const here = page.getByRole('table', { name: 'Clients' });
  await expect(here.getByRole('row', { name: /Anna/ })).toBeVisible();
  const robot = await room.program('Robot');
  await expect(here.getByRole('row', { name: /Robot/ })).toBeVisible();
  const phone = await room.withPhone('Ben');
  await phone.page.goto('/');
  await expect(here.getByRole('row', { name: /Ben/ })).toBeVisible();
  await robot.close();
  await expect(here.getByRole('row', { name: /Robot/ })).toHaveCount(0);
});

test('home draws records per second and says them', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  const robot = await room.program('Robot');
  let value = 0;
  const beat = setInterval(() => robot.publish('/lab/beat', 'double', value++), 20);
  await expect(
    page.getByRole('img', { name: /^Records per second over the last ten minutes: now [1-9]/ }),
  ).toBeVisible();
  clearInterval(beat);
});

test('from home the first example is one click away', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  await page
    .getByRole('region', { name: /^Examples/ })
    .getByRole('link', { name: /Mouse pointer/ })
    .click();
  await expect(page).toHaveURL(/\/examples\/mouse-pointer$/);
});

test('a name given in the settings is seen by others at once, and kept', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const ben = await room.atDesk('Ben');
  await Promise.all([anna.page.goto('/settings'), ben.page.goto('/')]);
  const here = ben.page.getByRole('table', { name: 'Clients' });
  await expect(here.getByRole('row', { name: /Anna/ })).toBeVisible();
  const name = anna.page.getByRole('textbox', { name: 'Name' });
  await name.fill('Annabel');
  await name.press('Enter');
  await expect(here.getByRole('row', { name: /Annabel/ })).toBeVisible();
  await anna.page.reload();
  await expect(name).toHaveValue('Annabel');
});
