import {
  expectAccessible,
  expectAccessibleEverywhere,
  onPhone,
} from '../../fixtures/accessible.ts';
import { callService } from '../../fixtures/call-service.ts';
import { followLink } from '../../fixtures/follow-link.ts';
import { HostileClient } from '../../fixtures/hostile-client.ts';
import { expect, test, type Room } from '../../fixtures/test.ts';
import { withoutDrawing } from '../../fixtures/without-drawing.ts';
import { PerformancePage } from '../../pages/performance-page.ts';
import { RecordingsPage } from '../../pages/recordings-page.ts';
import { Shell } from '../../pages/shell.ts';
import { StudiesPage } from '../../pages/studies-page.ts';
import pages from './pages.json' with { type: 'json' };

/** Pages without anything of their own in the address; for the others, see the stories below. The frontend's tests say when one is missing. */
const PAGES: readonly string[] = pages.opened;

/** Pages that are opened by their address: they say in their own header how it stands with the master, if they do. */
const HAS_OWN_HEADER = /^\/(devices\/|party|connect|join)/;

/** Layer of the tooltip, at the end of the document. */
const TOOLTIP = '.tooltip';

/** In dark; its light is looked at as well. */
const enter = (room: Room) => room.atDesk('Anna', { colorScheme: 'dark' });

/** Each page takes seconds, on a busy machine many: a test of all would be over its time. */
const PAGES_A_TEST = 8;
const GROUPS = Array.from({ length: Math.ceil(PAGES.length / PAGES_A_TEST) }, (_, index) =>
  PAGES.slice(index * PAGES_A_TEST, (index + 1) * PAGES_A_TEST),
);

for (const group of GROUPS) {
  const names = `${group[0]!} to ${group.at(-1)!}`;
  test(`pages from ${names} are accessible at a desk and on a phone`, async ({ master, room }) => {
    // Something to see on the pages: topics of several formats.
    const guest = await HostileClient.register(master.endpoints, 'guest');
    const socket = await guest.open();
    await socket.publish([
      { topic: '/guest/angle', double: 0.5 },
      { topic: '/guest/position', vector2: { x: 1, y: 2 } },
      { topic: '/guest/word', string: 'hello' },
      { topic: '/guest/pressed', bool: true },
    ]);
    const { page } = await enter(room);
    await withoutDrawing(page);
    const shell = new Shell(page);
    for (const path of group) {
      await test.step(path, async () => {
        const isOpened = path === group[0] || HAS_OWN_HEADER.test(path);
        await (isOpened ? page.goto(path) : followLink(page, path));
        await expect(shell.main.getByRole('heading', { level: 1 })).toBeVisible();
        if (!HAS_OWN_HEADER.test(path)) await shell.expectConnected();
        await expectAccessibleEverywhere(page);
      });
    }
    await test.step('colours of what only phones show', () =>
      onPhone(page, () => expectAccessible(page)));
    guest.leave();
  });
}

test('a recording and its timeline are accessible at a desk and on a phone', async ({ room }) => {
  const robot = await room.program('Robot');
  robot.publish('/lab/angle', 'double', 0.25, { immediate: true });
  robot.publish('/lab/word', 'string', 'rest', { immediate: true });
  const { page } = await enter(room);
  const recordings = new RecordingsPage({ page });
  await recordings.open();
  await recordings.button('Record').click();
  await expect(page.getByRole('dialog', { name: 'Record' })).toBeVisible();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await page.keyboard.press('Escape');
  await recordings.record('Study');
  await expectAccessibleEverywhere(page, TOOLTIP);
  robot.publish('/lab/angle', 'double', 0.5, { immediate: true });
  await expect(recordings.running.getByRole('definition').first()).not.toHaveText('0');
  await recordings.button('Stop recording').click();
  await expect(recordings.track('/lab/angle')).toBeVisible();
  await expectAccessibleEverywhere(page, TOOLTIP);
});

test('a study, its run and its participants are accessible at a desk and on a phone', async ({
  room,
}) => {
  const { page } = await enter(room);
  const studies = new StudiesPage({ page });
  await studies.open();
  await studies.button('Use the example').click();
  await expect(page.getByRole('table', { name: 'Preview of the orders' })).toBeVisible();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await studies.openPart('Run');
  await expect(studies.checks).toContainText('Missing');
  await expectAccessibleEverywhere(page, TOOLTIP);
  await studies.button('Start run').click();
  await studies.button('Show the consent text').click();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await page.getByRole('checkbox').check();
  await studies.button('I agree').click();
  await studies.button('Start').click();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await studies.button('Start anyway').click();
  await expect(studies.button('Stop')).toBeVisible();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await studies.button('Stop').click();
  await studies.button('End run early').click();
  await expect(page.getByRole('list', { name: 'Recordings of the run' })).toBeVisible();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await studies.openPart('Participants');
  await expect(studies.participants).toHaveCount(1);
  await expectAccessibleEverywhere(page, TOOLTIP);
});

test('a client and what is done to it are accessible at a desk and on a phone', async ({
  room,
}) => {
  const robot = await room.program('Robot');
  const components = [{ name: 'angle', format: 'double' }] as const;
  const arm = await robot.registerDevice({ name: 'arm', components });
  arm.component('angle').publish(0.25);
  await robot.subscribe('/lamp/level').ready;
  await robot.call('clientThrottle', { targetId: robot.id, recordsPerSecond: 5 });
  const { page } = await enter(room);
  await page.goto('/clients');
  const row = page.getByRole('treegrid', { name: 'Clients' }).getByRole('row', { name: /Robot/ });
  await row.focus();
  await page.keyboard.press('ArrowRight');
  await expect(page.getByRole('row', { name: /angle/ })).toContainText('0.25');
  await expectAccessibleEverywhere(page, TOOLTIP);
  await page.goto(`/clients/${robot.id}`);
  await expect(page.getByRole('list', { name: 'Problems' })).toContainText('throttled');
  await expect(page.getByRole('list', { name: 'Subscribed topics' })).toContainText('/lamp');
  await expectAccessibleEverywhere(page, TOOLTIP);
  await page.getByRole('button', { name: 'Rename Robot' }).click();
  await page.getByRole('textbox', { name: /^Name/ }).fill(' ');
  await expectAccessibleEverywhere(page, TOOLTIP);
  await page.getByRole('button', { name: 'Disconnect' }).last().click();
  await expect(page.getByRole('dialog')).toBeVisible();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await page.keyboard.press('Escape');
  await page.goto('/clients?view=load');
  await page.getByRole('button', { name: 'Remove throttle' }).click();
  await page.getByRole('button', { name: 'Throttle', exact: true }).first().waitFor();
  await expectAccessibleEverywhere(page, TOOLTIP);
  await page.goto('/clients/nobody');
  await expect(page.getByText('No client has this id now.')).toBeVisible();
  await expectAccessibleEverywhere(page, TOOLTIP);
  const id = await page.evaluate(() => /[0-9a-f-]{36}/.exec(JSON.stringify(sessionStorage))?.[0]);
  robot.publish(`/${id}/identify`, 'string', 'Mara', { immediate: true });
  await expect(page.getByRole('alert')).toContainText('Mara asked this device');
  await expectAccessibleEverywhere(page, TOOLTIP);
});

test('a session with problems is accessible at a desk and on a phone', async ({ master, room }) => {
  const onProcessingStringified = "() => { console.log('run'); throw new Error('again'); }";
  const { session } = await callService(master.endpoints, {
    topic: '/services/session/runtime/start',
    session: {
      name: 'Noisy',
      processingModules: [
        { name: 'noisy', language: 2, onProcessingStringified },
        { name: 'mirror-pointer' },
      ],
      ioMappings: [
        {
          processingModuleName: 'mirror-pointer',
          inputMappings: [
            { inputName: 'pointer', topic: '/nobody/publishes' },
            { inputName: 'mirrorX', constantJson: '{"bool":true}' },
          ],
        },
      ],
    },
  });
  const { page } = await enter(room);
  await page.goto(`/sessions/${session!.id}/log`);
  await expect(page.getByRole('list', { name: /^Events/ })).toContainText('again');
  await expect(page.getByText('has no value, so the input').first()).toBeVisible();
  await expectAccessibleEverywhere(page);
  await page.goto(`/sessions/${session!.id}/statistics`);
  await expect(page.getByRole('row', { name: /^noisy/ })).toBeVisible();
  await expectAccessibleEverywhere(page);
  await page.goto(`/sessions/${session!.id}/text`);
  await expect(page.getByRole('textbox', { name: 'Session as JSON' })).toBeVisible();
  await expectAccessibleEverywhere(page);
  await page.goto(`/sessions/${session!.id}`);
  await expect(page.getByRole('toolbar', { name: 'Graph tools' })).toBeVisible();
  await expectAccessibleEverywhere(page);
  await page.getByRole('group', { name: 'Module noisy' }).click();
  await expect(page.getByRole('heading', { name: 'noisy', exact: true })).toBeVisible();
  await expectAccessibleEverywhere(page);
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Add', exact: true }).click();
  await expect(page.getByRole('dialog', { name: 'Add to the graph' })).toBeVisible();
  await expect(page.getByRole('option').first()).toBeVisible();
  await expectAccessible(page);
  await page.keyboard.press('Escape');
  await page.goto('/sessions');
  await expect(page.getByRole('list', { name: 'Sessions' })).toContainText('Noisy');
  await expectAccessibleEverywhere(page);
});

test('what a test has measured is accessible at a desk and on a phone', async ({ room }) => {
  const { page } = await enter(room);
  const performance = new PerformancePage({ page });
  await performance.open();
  await performance.fill({ Rate: '20', 'Duration of each': '1' });
  await performance.measure();
  await expect(page.locator('canvas').first()).toBeVisible();
  await expectAccessibleEverywhere(page);
  await performance.measure();
  await performance.open('results');
  const boxes = page.getByRole('checkbox');
  await expect(boxes).toHaveCount(2);
  for (const box of await boxes.all()) await box.check();
  await expectAccessibleEverywhere(page);
  await page.getByRole('button', { name: 'Compare 2' }).click();
  await expect(page.locator('canvas').first()).toBeVisible();
  await expectAccessibleEverywhere(page);
});

test('a module that is written and tried is accessible at a desk and on a phone', async ({
  master,
  room,
}) => {
  await callService(master.endpoints, {
    topic: '/services/processing_module/database/save',
    processingModule: {
      name: 'adder',
      inputs: [
        { internalName: 'value', messageFormat: 'double' },
        { internalName: 'others', messageFormat: 'vector2', isRecordList: true },
      ],
      outputs: [{ internalName: 'sum', messageFormat: 'double' }],
      onProcessingStringified: "() => { console.log('run'); throw new Error('again'); }",
    },
  });
  const { page } = await enter(room);
  await page.goto('/modules/adder/edit');
  const code = page.getByRole('region', { name: 'Code', exact: true });
  await expect(code.getByText('No problems found.')).toBeVisible();
  const tryIt = page.getByRole('region', { name: 'Try it' });
  await tryIt.getByRole('button', { name: 'Step' }).click();
  await expect(tryIt).toContainText('again');
  await expectAccessible(page);
  await onPhone(page, async () => {
    for (const part of ['Code', 'Try it', 'About']) {
      await page.getByRole('radio', { name: part }).click();
      await expectAccessible(page);
    }
  });
  await page.goto('/modules');
  await page.getByRole('button', { name: 'New module', exact: true }).click();
  await expect(page.getByRole('dialog')).toBeVisible();
  await expectAccessibleEverywhere(page);
});

test('what opens over a page is accessible at a desk and on a phone', async ({ room }) => {
  const { page } = await enter(room);
  await page.goto('/');
  const shell = new Shell(page);
  await shell.expectConnected();
  await test.step('connect a phone', async () => {
    await shell.button('Connect a phone').click();
    await expect(page.getByRole('dialog')).toBeVisible();
    await expectAccessibleEverywhere(page);
    await page.keyboard.press('Escape');
    await expect(page.getByRole('dialog')).toBeHidden();
  });
  await test.step('command palette', async () => {
    await shell.button('Search or run a command').click();
    await expect(shell.palette).toBeVisible();
    await expectAccessibleEverywhere(page);
    await page.keyboard.press('Escape');
    await expect(shell.palette).toBeHidden();
  });
  await test.step('numbers of the connection', async () => {
    await shell.connection.click();
    const numbers = page.getByRole('dialog', { name: 'Connection' });
    await expect(numbers).toContainText('Round trip');
    await expectAccessibleEverywhere(page);
    await page.keyboard.press('Escape');
    await expect(numbers).toBeHidden();
  });
});

test('a graph that is begun on a tablet is accessible', async ({ master, room }) => {
  const { session } = await callService(master.endpoints, {
    topic: '/services/session/runtime/add',
    session: { name: 'Begun' },
  });
  const { page } = await room.atDesk('Anna', {
    viewport: { width: 1024, height: 768 },
    hasTouch: true,
    isMobile: true,
    colorScheme: 'dark',
  });
  await page.goto(`/sessions/${session!.id}`);
  await expect(page.getByRole('region', { name: 'Getting started' })).toBeVisible();
  await expect(page.getByRole('button', { name: /^Smooth a pointer/ })).toBeVisible();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Add', exact: true }).tap();
  await page.getByRole('button', { name: 'Keep open at the side' }).tap();
  const add = page.getByRole('button', { name: 'Add to graph: low-pass' });
  await page.locator('[data-palette-module="low-pass"]').tap();
  await expect(add).toBeVisible();
  await expectAccessible(page);
  await add.tap();
  await expect(page.getByRole('group', { name: 'Module low-pass' })).toBeVisible();
  await expectAccessible(page);
  await page.getByRole('button', { name: 'Details' }).tap();
  await expect(page.getByRole('heading', { name: 'low-pass', exact: true })).toBeVisible();
  await expectAccessible(page);
});

test('the strip that says the master is gone is accessible', async ({ master, room }) => {
  const { page, watch } = await enter(room);
  await page.goto('/');
  const shell = new Shell(page);
  await shell.expectConnected();
  watch.expect(/net::ERR_CONNECTION_(REFUSED|RESET)/, /WebSocket connection to .* failed/);
  await master.stop();
  await expect(shell.disconnectedStrip).toBeVisible();
  // Values that stand still are dimmed on purpose, below what texts need that can be acted on.
  await expectAccessible(page, '[data-live]');
});
