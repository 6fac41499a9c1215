import type { MasterProcess } from '@ubii/harness';
import {
  expectAccessible,
  expectAccessibleEverywhere,
  onPhone,
} from '../../fixtures/accessible.ts';
import { expect, test, type Person } from '../../fixtures/test.ts';
import { JoinPage } from '../../pages/join-page.ts';
import { Shell } from '../../pages/shell.ts';

/** A master as somebody gets it who says nothing: what is printed makes an admin. */
test.use({ masterStart: { flags: ['--trust-loopback', 'off'] } });

/** Refusals of services are answers with a status of their own, which browsers log. */
const REFUSED = /status of (401|403|429)/;

/** The address for this machine, as somebody reads it on the screen. */
function printedAddress(master: MasterProcess): string {
  const [address] = master.log.flatMap(
    (line) => /On this machine\s+(http:\S+)/.exec(line)?.[1] ?? [],
  );
  if (address === undefined) throw new Error('No address was printed.');
  return address;
}

/** What a role may do, as the page says it. */
const MAY = {
  admin: 'May do everything',
  participant: 'May use and change everything except codes',
};

/** The role, as the page says it. */
async function expectRole({ page }: Pick<Person, 'page'>, role: keyof typeof MAY): Promise<void> {
  await page.getByRole('button', { name: /^This browser/ }).click();
  const dialog = page.getByRole('dialog', { name: 'This browser' });
  await expect(dialog).toContainText(MAY[role]);
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
}

test('the printed address leads home as admin, over a reload, a new tab and a restart [AC-42] @smoke', async ({
  master,
  room,
}) => {
  const desk = await room.atDesk('Ada');
  desk.watch.expect(/WebSocket|ERR_CONNECTION_(REFUSED|RESET)/);
  await desk.page.goto(printedAddress(master));
  await expect(desk.page).toHaveURL(`${master.url}/`);
  await new Shell(desk.page).expectConnected();
  await expectRole(desk, 'admin');
  // The way back does not lead through the token
  expect(await desk.page.evaluate(() => history.state?.back ?? '')).not.toContain(
    master.endpoints.adminToken,
  );

  await desk.page.reload();
  await expectRole(desk, 'admin');
  const second = await desk.context.newPage();
  await second.goto('/settings/log');
  await expect(second.getByText(/^\d+ lines?\./)).toBeVisible();
  await second.close();

  await master.stop();
  await master.restart();
  await desk.page.reload();
  await new Shell(desk.page).expectConnected();
  await expectRole(desk, 'admin');
});

test('the bare address is for participants, who enter the code where an admin is needed', async ({
  master,
  room,
}) => {
  const desk = await room.atDesk('Ben');
  desk.watch.expect(REFUSED);
  const { page } = desk;
  const join = new JoinPage(desk);
  const button = page.getByRole('main').getByRole('link', {
    name: 'Enter the code shown in the terminal',
  });
  await page.goto('/');
  await new Shell(page).expectConnected();
  await expectRole(desk, 'participant');

  await page.goto('/settings/master');
  await expect(page.getByText('Only admins can see the start options')).toBeVisible();
  await page.goto('/connect');
  await expect(page.getByText('Phones cannot reach this computer')).toBeVisible();
  await page.goto('/settings/audit');
  await expect(page.getByText('only admins can read it')).toBeVisible();
  await expect(page.getByRole('alert')).toHaveCount(0);
  await page.goto('/settings/log');
  await expect(page.getByText('only admins can read it')).toBeVisible();
  await expect(page.getByRole('alert')).toHaveCount(0);

  await test.step('a user who does not want to become admin continues as before', async () => {
    await button.click();
    await page.getByRole('button', { name: 'Continue' }).click();
    await expect(page).toHaveURL(/\/settings\/log$/);
    await expectRole(desk, 'participant');
  });

  await button.click();
  await expect(join.heading).toHaveText('Enter the code.');

  await join.type('0000-0000');
  await expect(join.heading).toHaveText('This code is not valid.');
  await join.type(master.endpoints.adminCode.toLowerCase());
  await expect(page).toHaveURL(/\/settings\/log$/);
  await expect(page.getByText(/^\d+ lines?\./)).toBeVisible();
  await expect(button).toHaveCount(0);
  await expectRole(desk, 'admin');
});

test('becoming admin is accessible and fits a phone', async ({ room }) => {
  const { page } = await room.atDesk('Dora', { colorScheme: 'dark' });
  const expectToFit = async () => expect(await new Shell(page).overflowPx()).toBeLessThanOrEqual(0);
  for (const path of [
    '/settings/log',
    '/settings/master#flags',
    '/connect',
    '/join?another=admin',
  ]) {
    await page.goto(path);
    await expect(page.getByText(/code|terminal/i).first()).toBeVisible();
    await expectToFit();
    await expectAccessibleEverywhere(page);
    await onPhone(page, expectToFit);
  }
  await test.step('colours of what only phones show', () =>
    onPhone(page, () => expectAccessible(page)));
});
