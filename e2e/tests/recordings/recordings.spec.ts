import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { FROM_ELSEWHERE, JoinPage } from '../../pages/join-page.ts';
import { RecordingsPage } from '../../pages/recordings-page.ts';
import { makeGrant } from '../connect/make-grant.ts';

test('K keeps the last minutes on any page, under a name that is edited at once', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/angle', 'double', 0.25, { immediate: true });
  const anna = new RecordingsPage(await room.atDesk('Anna'));
  await anna.open();
  await expect(anna.keep).not.toHaveAttribute('aria-disabled');

  await anna.page.goto('/clients');
  await expect(anna.page.getByRole('row', { name: /Robot/ })).toBeVisible();
  await anna.page.keyboard.press('k');
  const name = anna.page.getByRole('textbox', { name: 'Name of the recording' });
  await name.fill('The good one');
  await name.press('Enter');
  await expect(name).toBeHidden();

  await anna.open();
  await anna.row('The good one').getByRole('link').click();
  await expect(anna.track('/lab/angle')).toBeVisible();
});

test('a recording is made, opened and scrubbed, and its graph shows the values of that moment @smoke', async ({
  master,
  room,
}) => {
  const id = await placedSession(master, {
    copy: { x: 300, y: 100, reads: '/lab/angle', writes: '/lab/copied', isTriggered: true },
  });
  await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeStart.topic,
    session: { id },
  });
  const robot = await room.program('Robot');
  const anna = new RecordingsPage(await room.atDesk('Anna'));
  await anna.open();
  await anna.record('Study');
  const copied: number[] = [];
  const copies = robot.subscribe('/lab/copied', { format: 'double' });
  copies.onRecord(({ value }) => copied.push(value));
  await copies.ready;
  for (const value of [0.25, 0.5, 0.75]) {
    robot.publish('/lab/angle', 'double', value, { immediate: true });
    await expect.poll(() => copied).toContain(value);
  }
  robot.publish('/lab/done', 'bool', true, { immediate: true });
  await anna.expectRecords(7);
  await anna.page.keyboard.press('m');
  await expect(anna.page.getByText('Moment marked')).toBeVisible();
  await anna.button('Stop recording').click();

  const angle = anna.track('/lab/angle');
  await angle.click();
  await anna.button('Go to the end').click();
  await expect(angle).toContainText('0.75');
  await expect(anna.inspector).toContainText('0.750');
  await expect(anna.graph).toContainText('0.75');
  // To the last record, and to the one before it.
  await anna.page.keyboard.press('ArrowLeft');
  await anna.page.keyboard.press('ArrowLeft');
  await expect(angle).toContainText('0.50');
  await expect(anna.graph).toContainText('0.50');
  await anna.page.getByRole('radio', { name: 'Plot' }).click();
  await expect(anna.page.getByRole('region', { name: 'Recorded plots' })).toContainText('/lab/');
  await anna.page.getByRole('radio', { name: 'Graph' }).click();

  await test.step('a span becomes a test case of the module', async () => {
    await anna.button('Loop what is in view').click();
    await anna.page.getByRole('button', { name: /^Actions for the span/ }).click();
    await anna.page.getByRole('menuitem', { name: 'Make a test case of a module' }).click();
    const dialog = anna.page.getByRole('dialog', { name: 'Test case of a module' });
    await dialog.getByRole('button', { name: 'Run the case' }).click();
    await expect(dialog).toContainText('Passed');
    await dialog.getByRole('button', { name: 'Close' }).click();
    await anna.button('Stop looping').click();
  });

  await test.step('a marker is added, named and deleted', async () => {
    // One was added while the recording ran.
    await expect(anna.markers).toHaveCount(1);
    await anna.markers.click();
    const dialog = anna.page.getByRole('dialog');
    await dialog.getByLabel('Text').fill('half way');
    await dialog.getByRole('button', { name: 'Save' }).click();
    await expect(anna.markers).toHaveAccessibleName(/half way/);
    await anna.page.keyboard.press('m');
    await expect(anna.markers).toHaveCount(2);
    // It is in the file.
    await anna.page.reload();
    await expect(anna.markers).toHaveCount(2);
    await anna.timeline.getByRole('button', { name: /half way/ }).click();
    await dialog.getByRole('button', { name: 'Delete' }).click();
    await expect(anna.markers).toHaveCount(1);
  });

  await test.step('notes are written, and shown above the recording', async () => {
    await anna.button('More for Study').click();
    await anna.page.getByRole('menuitem', { name: 'Name and notes' }).click();
    const dialog = anna.page.getByRole('dialog', { name: 'Name and notes' });
    await dialog.getByLabel('Notes').fill('The left strap was loose.');
    await dialog.getByRole('button', { name: 'Save' }).click();
    await expect(anna.page.getByRole('article', { name: 'Recording Study' })).toContainText(
      'The left strap was loose.',
    );
  });

  await test.step('Space plays it as soon as it is opened from the list', async () => {
    await anna.open();
    await anna.row('Study').getByRole('link').click();
    await expect(angle).toBeVisible();
    await anna.page.keyboard.press('Space');
    await expect(anna.page.getByRole('group', { name: 'Playback' })).not.toContainText('0:00.000');
  });

  await test.step('the file is opened without the master', async () => {
    const download = anna.page.waitForEvent('download');
    await anna.page.getByRole('link', { name: 'Download' }).click();
    const path = await (await download).path();
    await anna.button('More for Study').click();
    await anna.page.getByRole('menuitem', { name: 'Delete' }).click();
    await anna.page.getByRole('dialog').getByRole('button', { name: 'Delete' }).click();
    await expect(anna.row('Study')).toBeHidden();
    await anna.page.locator('input[type=file]').setInputFiles(path);
    await expect(anna.page.getByRole('article', { name: 'Recording Study' })).toContainText(
      'a file of this device',
    );
    await anna.button('Go to the end').click();
    await expect(angle).toContainText('0.75');
    await expect(anna.page.getByText('The left strap was loose.')).toBeVisible();
  });
});

test('a phone that joined with an invitation makes a recording, scrubs it and downloads it', async ({
  master,
  room,
}) => {
  const robot = await room.program('Robot');
  const phone = await room.withPhone('Ben', FROM_ELSEWHERE);
  phone.watch.expect(/status of (401|403)/);
  const { token } = await makeGrant(master, { target: '/recordings' });
  await phone.page.goto(`/join#${token}`);
  await new JoinPage(phone).join.tap();
  const ben = new RecordingsPage(phone);
  await ben.record('Walk');
  const values = [0.25, 0.75];
  for (const [index, value] of values.entries()) {
    robot.publish('/lab/angle', 'double', value, { immediate: true });
    await ben.expectRecords(index + 1);
  }
  robot.publish('/lab/done', 'bool', true, { immediate: true });
  await ben.expectRecords(values.length + 1);
  await test.step('every page says so, and marks the moment', async () => {
    await ben.page.goto('/topics');
    const strip = ben.page.getByRole('status', { name: 'Recordings' });
    await expect(strip).toContainText('Recording Walk');
    await strip.getByRole('button', { name: 'Mark' }).tap();
    const text = ben.page.getByRole('textbox', { name: 'Text of the marker' });
    await text.fill('stumbled');
    await text.press('Enter');
    await expect(text).toBeHidden();
    await strip.getByRole('link', { name: 'Open recording' }).tap();
  });
  await ben.button('Stop recording').tap();
  await expect(ben.markers).toHaveAccessibleName(/stumbled/);

  await expect(ben.inspector).toContainText('0.250');
  const box = await ben.page.getByRole('group', { name: 'Tracks' }).boundingBox();
  await ben.page.touchscreen.tap(box!.x + box!.width - 2, box!.y + 10);
  await expect(ben.inspector).toContainText('0.750');
  const download = ben.page.waitForEvent('download');
  await ben.page.getByRole('link', { name: 'Download' }).tap();
  expect((await download).suggestedFilename()).toBe('Walk.mcap');
  await ben.page.goto('/recordings');
  await ben.page.getByRole('button', { name: 'Preview of Walk' }).tap();
  await expect(ben.page.getByRole('list', { name: 'Busiest topics' })).toContainText('2 records');
});
