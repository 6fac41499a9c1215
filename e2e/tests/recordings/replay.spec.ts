import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { RecordingsPage } from '../../pages/recordings-page.ts';

test('a recording plays into live topics, mutes who publishes them, and lets go of them again [RP-20] @smoke', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const publish = (value: number): void =>
    robot.publish('/lab/angle', 'double', value, { immediate: true });
  const anna = new RecordingsPage(await room.atDesk('Anna'));
  await anna.open();
  await anna.record('Study');
  for (const [index, value] of [0.25, 0.5].entries()) {
    publish(value);
    await anna.expectRecords(index + 1);
  }
  robot.publish('/lab/done', 'bool', true, { immediate: true });
  await anna.expectRecords(3);
  await anna.button('Stop recording').click();
  await expect(anna.track('/lab/angle')).toContainText('0.25');
  publish(0.9);

  const ben = await room.atDesk('Ben');
  await ben.page.goto('/topics/%2Flab%2Fangle');
  const topic = ben.page.getByRole('article', { name: 'Topic /lab/angle' });
  await expect(topic).toContainText('0.90');

  await test.step('a dialog names who publishes the same topics', async () => {
    // In a loop, so that it goes on.
    await anna.button('Loop what is in view').click();
    await anna.playInto('Live topics');
    const dialog = anna.page.getByRole('dialog', { name: 'Play into live topics' });
    await expect(
      dialog.getByRole('list', { name: 'Clients that publish these topics now' }),
    ).toContainText('Robot');
    await dialog.getByRole('button', { name: 'Play live' }).click();
    await expect(anna.liveBanner).toContainText('Robot is muted until you stop.');
  });

  await test.step('another page receives the recording, and says who plays it', async () => {
    await expect(topic).toContainText('0.50');
    const strip = ben.page.getByRole('status', { name: 'Replays' });
    await expect(strip).toContainText('Anna plays recording “Study” into 2 live topics.');
    // The robot goes on, but nobody receives it.
    publish(0.7);
    await expect(topic).toContainText('Live records are muted');
    await expect(topic).not.toContainText('0.70');
  });

  await test.step('live records flow again after the stop, with the last live value', async () => {
    await ben.page.getByRole('button', { name: 'Stop', exact: true }).click();
    await expect(anna.liveBanner).toBeHidden();
    await expect(topic).toContainText('0.70');
    publish(0.8);
    await expect(topic).toContainText('0.80');
  });
});

test('a span becomes ghosts, and a session runs again on recorded inputs [RP-30] [RP-40]', async ({
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
  for (const [index, value] of [0.25, 0.5, 0.75].entries()) {
    robot.publish('/lab/angle', 'double', value, { immediate: true });
    // One record of the robot, and one of the module.
    await anna.expectRecords(2 * (index + 1));
  }
  robot.publish('/lab/done', 'bool', true, { immediate: true });
  await anna.expectRecords(7);
  await anna.button('Stop recording').click();
  await expect(anna.track('/lab/angle')).toContainText('0.25');

  await test.step('two ghosts play the span in a loop beside the robot', async () => {
    await anna.button('Loop what is in view').click();
    await anna.page.getByRole('button', { name: /^Actions for the span/ }).click();
    await anna.page.getByRole('menuitem', { name: 'Make a ghost' }).click();
    const dialog = anna.page.getByRole('dialog', { name: 'Make a ghost' });
    await dialog.getByLabel('Name').fill('Visitor');
    await dialog.getByLabel('Copies').fill('2');
    await dialog.getByRole('button', { name: 'Start' }).click();
    const rows = anna.page.getByRole('list', { name: 'Replays' }).getByRole('listitem');
    await expect(rows).toContainText('2 copies of “Visitor” play in a loop.');
    await anna.page.getByRole('button', { name: 'Stop Visitor' }).click();
    await expect(rows).toBeHidden();
  });

  await test.step('outputs are the same while the library has no other code', async () => {
    await anna.button('Run today’s modules').click();
    await expect(anna.comparison).toContainText('outputs are the same as recorded');
    await expect(anna.comparison).toContainText('ran with the recorded code');
    await anna.button('Close the comparison').click();
    await expect(anna.comparison).toBeHidden();
  });

  const saveCopy = async (result: string): Promise<void> => {
    await callService(master.endpoints, {
      topic: SERVICES.processingModuleDatabaseSave.topic,
      processingModule: {
        name: 'copy',
        inputs: [{ internalName: 'value', messageFormat: 'double' }],
        outputs: [{ internalName: 'result', messageFormat: 'double' }],
        onProcessingStringified: `(deltaTime, { value }) => ({ outputs: { result: ${result} } })`,
      },
    });
  };

  await test.step('a module that fails today is named', async () => {
    await saveCopy('9');
    await anna.button('Run today’s modules').click();
    await expect(anna.comparison).toContainText('differ from the recording');
    await expect(anna.comparison).toContainText('A run of the module "copy" failed');
    await anna.button('Close the comparison').click();
  });

  await test.step('other code of today is compared with what was recorded', async () => {
    await saveCopy('value?.double === 0.5 ? { double: 9 } : value');
    await anna.button('Run today’s modules').click();
    await expect(anna.comparison).toContainText(/differs? from the recording/);
    const difference = anna.comparison.getByRole('list', { name: 'Differences' });
    await expect(difference).toContainText('0.50');
    await expect(difference).toContainText('9.00');
    await anna.button('Go to the next one').click();
    await expect(anna.track('/lab/copied')).toContainText('0.50');
  });
});
