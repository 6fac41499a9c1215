import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import { expect, test, type Person, type Room } from '../../fixtures/test.ts';
import { FROM_ELSEWHERE, JoinPage } from '../../pages/join-page.ts';
import { withoutWebGl } from '../../pages/party-pages.ts';

test.use({ masterStart: { flags: ['--lan', 'on', '--mdns', 'off'] } });

const PHOTOS = join(import.meta.dirname, '../../../packages/vision/photos');
/** A cup is the thing that one of the photographs shows. */
const THING = 'a cup';

/** Gives the page a camera that sees a photograph, moving a little as in a hand. */
async function showPhotograph(page: Page, file: string): Promise<void> {
  const picture = readFileSync(join(PHOTOS, file)).toString('base64');
  await page.addInitScript((base64) => {
    navigator.mediaDevices.getUserMedia = async () => {
      const image = new Image();
      image.src = `data:image/jpeg;base64,${base64}`;
      await image.decode();
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [image.width, image.height];
      const context = canvas.getContext('2d')!;
      let frame = 0;
      setInterval(() => context.drawImage(image, frame++ % 2, 0), 100);
      return canvas.captureStream();
    };
  }, picture);
}

/** A phone that joins the party by its code, from elsewhere. */
async function joinParty(room: Room, name: string, code: string): Promise<Person> {
  const phone = await room.withPhone(name, { ...FROM_ELSEWHERE, permissions: ['camera'] });
  phone.watch.expect(/status of (401|403)/, /WebSocket/);
  await showPhotograph(phone.page, 'coffee.jpg');
  const join = new JoinPage(phone);
  await phone.page.goto('/join');
  await join.type(code);
  await join.join.click();
  await expect(phone.page).toHaveURL(/\/party\/play/);
  await phone.page.getByLabel('Your name', { exact: true }).fill(name);
  await phone.page.getByRole('button', { name: 'Join', exact: true }).click();
  return phone;
}

/** A tournament of one hunt, for the one thing that there is. */
async function chooseHunt({ page }: Person): Promise<void> {
  const games = page.getByRole('group', { name: 'Games of the tournament' });
  for (const game of ['Marble Dash', 'King of the Hill'])
    await games.getByRole('button', { name: game }).click();
  await page.getByRole('button', { name: 'Host' }).click();
  const things = page.getByRole('group', { name: 'Things in this room' });
  for (const box of await things.getByRole('checkbox').all()) await box.uncheck();
  await things.getByRole('checkbox', { name: THING, exact: true }).check();
  await page.getByRole('button', { name: 'Close' }).click();
}

test('two phones hunt a cup: one shows the photo until the host takes it down, one keeps it private', async ({
  room,
}) => {
  test.slow();
  const robot = await room.program('Robot');
  const host = await room.atDesk('Host');
  await withoutWebGl(host.page);
  await host.page.goto('/party');
  const code = (await host.page.locator('[data-join-code]').textContent()) ?? '';
  const mara = await joinParty(room, 'Mara', code.replace(/\W/g, ''));
  const theo = await joinParty(room, 'Theo', code.replace(/\W/g, ''));
  const card = (name: string) =>
    host.page.getByRole('list', { name: 'Photos' }).getByRole('listitem').filter({ hasText: name });
  const shutter = ({ page }: Person) => page.getByRole('button', { name: 'Take the photo' });

  await test.step('the explanation loads the detector, which looks on the phone itself', async () => {
    await chooseHunt(host);
    await host.page.getByRole('button', { name: 'Start', exact: true }).click();
    await mara.page.getByRole('switch', { name: /^Show my photos/ }).tap();
    for (const { page } of [mara, theo])
      await expect(page.getByText('The detector is ready')).toBeVisible();
    for (const { page } of [mara, theo]) {
      await page.getByRole('button', { name: 'Ready', exact: true }).tap();
    }
    await expect(host.page.getByRole('heading', { name: `Find ${THING}` })).toBeVisible();
  });

  await test.step('the phone says what it sees before the shutter is pressed', async () => {
    await expect(mara.page.getByText('That’s a cup. Take it!').first()).toBeVisible();
    await shutter(mara).tap();
    await expect(card('Mara')).toContainText(/1st \+\d/);
    await expect(card('Mara').getByRole('img', { name: 'Photo of Mara' })).toBeVisible();
    await expect(card('Mara')).toContainText(/cup \d\d/);
  });

  await test.step('the host takes the photo down, and it is gone everywhere', async () => {
    const photos = async (): Promise<readonly string[]> =>
      (await robot.call('topicList')).elements.filter((topic) => topic.endsWith('/party/photo'));
    expect(await photos()).toHaveLength(1);
    await host.page.keyboard.press('1');
    await expect(card('Mara')).toContainText('Mara keeps it private');
    await expect.poll(photos).toEqual([]);
  });

  await test.step('a picture file may be handed in; a wrong one is said to be wrong', async () => {
    const file = theo.page.locator('input[type=file]');
    await file.setInputFiles(join(PHOTOS, 'chelsea.jpg'));
    await expect(card('Theo')).toContainText(`not ${THING}`);
    await expect(theo.page.getByText('The phone recognized: cat').first()).toBeVisible();
    await expect(shutter(theo)).toBeEnabled();
    await shutter(theo).tap();
    await expect(theo.page.getByText(/^Found as 2nd: \+\d/).first()).toBeVisible();
    await expect(card('Theo')).toContainText('Theo keeps it private');
    await expect(card('Theo').getByRole('img')).toHaveCount(0);
  });
});
