import type { UbiiClient } from '@ubii/client-web';
import { expect, test } from '../../fixtures/test.ts';
import { ClientsPage } from '../../pages/clients-page.ts';
import { Shell } from '../../pages/shell.ts';

/** Publishes on some topics, many times a second, until it is stopped. */
function beat(client: UbiiClient, topics: number): () => void {
  let value = 0;
  const timer = setInterval(() => {
    for (let i = 0; i < topics; i++) client.publish(`/drum/${i}`, 'double', value++);
  }, 20);
  return () => clearInterval(timer);
}

test('clients are listed with their devices, components and live values @smoke', async ({
  room,
}) => {
  const anna = await room.atDesk('Anna');
  const clients = new ClientsPage(anna);
  const robot = await room.program('Robot');
  const arm = await robot.registerDevice({
    name: 'arm',
    components: [
      { name: 'angle', format: 'double' },
      { name: 'grip', format: 'bool', ioType: 'subscriber' },
    ],
  });
  arm.component('angle').publish(0.25);
  await clients.open();
  await expect(clients.row('Anna')).toContainText('this browser');

  const row = clients.row('Robot');
  await expect(row).toHaveAttribute('aria-expanded', 'false');
  await row.click();
  await expect(clients.detail('Robot').getByRole('list', { name: /^Components/ })).toContainText(
    '0.25',
  );
  await row.press('ArrowRight');
  await expect(clients.row('arm')).toContainText('2 components');
  await expect(clients.row('angle')).toContainText('publishes');
  await expect(clients.row('angle')).toContainText('0.25');
  arm.component('angle').publish(0.5);
  await expect(clients.row('angle')).toContainText('0.50');
  await expect(clients.row('grip')).toContainText('takes');

  await clients.row('angle').click();
  await expect(anna.page).toHaveURL(/\/topics\//);
});

test('the page of clients tells what programs do, and throttles them', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const drum = await room.program('Drum');
  const robot = await room.program('Robot');
  const clients = new ClientsPage(anna);

  await test.step('what a client listens to is listed, topics and patterns', async () => {
    await robot.subscribe('/lamp/level', { maxRateHz: 5 }).ready;
    await robot.subscribe({ regex: '^/pads/.*$' }).ready;
    await clients.open(`/${robot.id}`);
    const list = clients.detail('Robot').getByRole('list', { name: 'Subscribed topics' });
    await expect(list).toContainText('/lamp/level');
    await expect(list).toContainText('at most 5.0 Hz');
    await expect(list).toContainText('^/pads/.*$');
  });

  await test.step('a program that does not listen for it is named', async () => {
    await clients.choose('Robot', 'Identify');
    await expect(anna.page.getByText('Robot does not support identification')).toBeVisible();
  });

  await test.step('the list is used with the keyboard alone', async () => {
    await clients.open();
    await expect(clients.row('Robot')).toBeVisible();
    await clients.row('Anna').focus();
    await anna.page.keyboard.press('End');
    await expect(clients.row('Robot')).toBeFocused();
    await anna.page.keyboard.press('ArrowUp');
    await expect(clients.row('Drum')).toBeFocused();
    await anna.page.keyboard.type('ro');
    await expect(clients.row('Robot')).toBeFocused();
    await anna.page.keyboard.press('Enter');
    await expect(clients.detail('Robot')).toBeVisible();
    await expect(anna.page).toHaveURL(new RegExp(`/clients/${robot.id}$`));

    await clients.row('Robot').focus();
    await anna.page.keyboard.press('F2');
    const name = anna.page.getByRole('textbox', { name: 'Name shown to others' });
    await expect(name).toBeFocused();
    await expect(name).toHaveValue('Robot');
    await anna.page.keyboard.press('Escape');
    await expect(name).toHaveCount(0);

    await clients.row('Robot').focus();
    await anna.page.keyboard.press('Delete');
    await expect(clients.dialog(/^Disconnect Robot/)).toContainText('This cannot be undone.');
    await anna.page.keyboard.press('Escape');
    await expect(clients.dialog(/^Disconnect/)).toHaveCount(0);
    await expect(clients.row('Robot')).toBeVisible();
  });

  await test.step('the heaviest client is ranked with the cause, and throttled with a reason', async () => {
    await room.program('Lamp');
    const stop = beat(drum, 10);
    await clients.open('?view=load');
    const row = clients.loads.getByRole('listitem').filter({ hasText: 'Drum' });
    await expect(row).toContainText(/Publishes .* records per second/);
    await expect(clients.loads.getByRole('listitem').first()).toContainText('Drum');

    await row.getByRole('button', { name: 'Throttle' }).click();
    const dialog = clients.dialog(/^Throttle Drum/);
    await dialog.getByRole('textbox', { name: 'Records per second' }).fill('ten');
    await expect(dialog.getByText('Enter a number of records per second')).toBeVisible();
    await dialog.getByRole('textbox', { name: 'Records per second' }).fill('20');
    await dialog.getByRole('textbox', { name: /^Reason/ }).fill('too loud');
    await dialog.getByRole('button', { name: 'Throttle' }).click();
    await expect(dialog).toHaveCount(0);
    await expect(row).toContainText('throttled to 20 records per second by Anna: too loud', {
      ignoreCase: true,
    });
    await row.getByRole('button', { name: 'Remove throttle' }).click();
    await expect(row.getByRole('button', { name: 'Throttle', exact: true })).toBeVisible();
    stop();
  });

  await test.step('only what is broken shows what needs attention, with the words for it', async () => {
    await robot.call('clientThrottle', { targetId: drum.id, recordsPerSecond: 5 });
    await clients.open('?broken=1');
    await expect(clients.row('Drum')).toContainText('throttled');
    await expect(clients.row('Robot')).toHaveCount(0);
  });
});

test('the list of clients finds and identifies a phone, and fits it', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const ben = await room.withPhone('Ben');
  await ben.page.goto('/');
  await new Shell(ben.page).expectConnected();
  const clients = new ClientsPage(anna);
  await clients.open();

  await test.step('a browser that is to be identified shows itself and says who asks', async () => {
    await clients.choose('Ben', 'Identify');
    const note = ben.page.getByRole('alert').filter({ hasText: 'asked this device' });
    await expect(note).toContainText('Anna asked this device to identify itself.');
    await expect(anna.page.getByText('Asked Ben to identify itself.')).toBeVisible();
    await note.getByRole('button', { name: 'Dismiss' }).click();
    await expect(note).toHaveCount(0);
  });

  await test.step('one looks for clients, and the address says what is looked for', async () => {
    await room.program('Robot');
    await expect(clients.row('Ben')).toBeVisible();

    await anna.page.getByRole('combobox', { name: 'Kind' }).click();
    await anna.page.getByRole('option', { name: 'phones' }).click();
    await expect(clients.row('Robot')).toHaveCount(0);
    await expect(clients.row('Ben')).toBeVisible();
    await expect(anna.page).toHaveURL(/kind=phone/);

    await clients.search.fill('nobody');
    await expect(anna.page.getByText('No client matches')).toBeVisible();
    await anna.page.getByRole('button', { name: /^Show all/ }).click();
    await expect(clients.row('Robot')).toBeVisible();

    await clients.open('?kind=program&sort=in');
    await expect(clients.row('Robot')).toBeVisible();
    await expect(clients.row('Ben')).toHaveCount(0);
    await anna.page.getByRole('button', { name: 'Sends /s' }).click();
    await expect(anna.page).toHaveURL(/order=up/);
    await anna.page.reload();
    await expect(anna.page.getByRole('columnheader', { name: 'Sends /s' })).toHaveAttribute(
      'aria-sort',
      'ascending',
    );
  });

  await test.step('on a phone clients are cards, and one leads to all of it and back', async () => {
    const onPhone = new ClientsPage(ben);
    await onPhone.open('?kind=program');
    const row = onPhone.row('Robot');
    await expect(row).toContainText('Round trip');
    await row.tap();
    await expect(onPhone.detail('Robot')).toBeVisible();
    await expect(onPhone.list).toBeHidden();
    const shell = new Shell(ben.page);
    expect(await shell.overflowPx()).toBe(0);
    await ben.page.getByRole('link', { name: 'Back to Clients' }).tap();
    await expect(onPhone.list).toBeVisible();
    await expect(ben.page).toHaveURL(/\/clients\?kind=program$/);
    expect(await shell.overflowPx()).toBe(0);
  });
});

test('another page is renamed, throttled and disconnected', async ({ room }) => {
  const anna = await room.atDesk('Anna');
  const ben = await room.atDesk('Ben');
  await ben.page.goto('/settings');
  const clients = new ClientsPage(anna);
  await clients.open();

  await test.step('a throttled page is told so, with the cause', async () => {
    await clients.choose('Ben', 'Throttle');
    const dialog = clients.dialog(/^Throttle Ben/);
    await dialog.getByRole('textbox', { name: 'Records per second' }).fill('5');
    await dialog.getByRole('textbox', { name: /^Reason/ }).fill('we are measuring');
    await dialog.getByRole('button', { name: 'Throttle' }).click();
    await expect(ben.page.getByRole('status', { name: 'Warning' })).toContainText(
      'This page is throttled to 5 records per second by Anna: we are measuring',
    );
    await clients.choose('Ben', 'Remove throttle');
    await expect(ben.page.getByRole('status', { name: 'Warning' })).toHaveCount(0);
  });

  await test.step('a client is disconnected with a reason, is told so, and joins again', async () => {
    await clients.choose('Ben', 'Disconnect');
    const dialog = clients.dialog(/^Disconnect Ben/);
    await expect(dialog).toContainText('This cannot be undone.');
    await dialog.getByRole('textbox', { name: /^Reason/ }).fill('the session is over');
    await dialog.getByRole('button', { name: 'Disconnect' }).click();
    await expect(clients.row('Ben')).toHaveCount(0);
    await expect(clients.note).toContainText('Ben was disconnected by Anna: the session is over');

    const strip = new Shell(ben.page).disconnectedStrip;
    await expect(strip).toContainText('disconnected by Anna: the session is over');
    await strip.getByRole('button', { name: 'Connect' }).click();
    await expect(clients.row('Ben')).toBeVisible();
    await expect(clients.note).toContainText(/Ben reconnected/);
  });

  await test.step('a client that left keeps its address, and shows there when it is back', async () => {
    await clients.row('Ben').click();
    await clients.choose('Ben', 'Disconnect');
    await clients
      .dialog(/^Disconnect/)
      .getByRole('button', { name: 'Disconnect' })
      .click();
    await expect(anna.page.getByText('Ben was disconnected by Anna, ')).toBeVisible();
    await new Shell(ben.page).disconnectedStrip.getByRole('button', { name: 'Connect' }).click();
    await expect(clients.detail('Ben')).toBeVisible();
    await clients.open('/nobody-at-all');
    await expect(anna.page.getByText('No client has this id now.')).toBeVisible();
  });

  await test.step('a client gets another name, and calls itself by it', async () => {
    await clients.open();
    await clients.choose('Ben', 'Rename');
    const name = anna.page.getByRole('textbox', { name: 'Name shown to others' });
    await name.fill(' ');
    await expect(anna.page.getByText('Enter a name of at least one character')).toBeVisible();
    await name.fill('Stage left');
    await name.press('Enter');
    await expect(clients.row('Stage left')).toBeVisible();
    await expect(clients.row('Ben')).toHaveCount(0);
    await expect(ben.page.getByRole('textbox', { name: 'Name' })).toHaveValue('Stage left');
  });
});
