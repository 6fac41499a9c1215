import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { Fingers, middleOf } from '../../pages/touch.ts';

const TABLET = {
  viewport: { width: 1024, height: 768 },
  hasTouch: true,
  isMobile: true,
} as const;

async function aSession(master: MasterProcess, ...names: readonly string[]): Promise<string> {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: { name: 'Touch', processingModules: names.map((name) => ({ name })) },
  });
  return session!.id;
}

test('fingers wire, zoom, drag and ask for the menu on a tablet', async ({ room, master }) => {
  const { page } = await room.atDesk('Ines', TABLET);
  const graph = new GraphPage({ page });
  const fingers = await Fingers.on(page);
  await graph.open(await aSession(master, 'clock', 'low-pass'));
  const lowPass = graph.node('Module low-pass');
  const value = graph.socket('Module low-pass', 'Input value');

  await test.step('tap and tap makes a wire, and cancel stops it', async () => {
    const hint = page.getByText('Tap the target');
    await fingers.tapOn(graph.socket('Module clock', 'Output sine'));
    await expect(hint).toBeVisible();
    await page.getByRole('button', { name: 'Cancel' }).tap();
    await expect(hint).toBeHidden();
    await fingers.tapOn(graph.socket('Module clock', 'Output sine'));
    await expect(hint).toBeVisible();
    await fingers.tapOn(value);
    await expect(value).toHaveAccessibleName(/1 connected/);
    await expect(hint).toBeHidden();
  });

  await test.step('one finger pans, and drags a node', async () => {
    const before = (await lowPass.boundingBox())!;
    const spot = await graph.spot(0.5, 0.95);
    await fingers.drag(spot, { x: spot.x, y: spot.y - 60 });
    await expect.poll(async () => (await lowPass.boundingBox())!.y - before.y).toBeCloseTo(-60, -1);
    const now = (await lowPass.boundingBox())!;
    const head = { x: now.x + now.width / 2, y: now.y + 20 };
    await fingers.drag(head, { x: head.x - 40, y: head.y + 50 });
    await expect.poll(async () => (await lowPass.boundingBox())!.y - now.y).toBeGreaterThan(30);
  });

  await test.step('two fingers zoom around the place between them', async () => {
    const before = (await lowPass.boundingBox())!;
    const { x, y } = await graph.spot(0.5, 0.5);
    await fingers.pinch(
      [
        { x: x - 40, y },
        { x: x + 40, y },
      ],
      [
        { x: x - 60, y },
        { x: x + 60, y },
      ],
    );
    await expect
      .poll(async () => (await lowPass.boundingBox())!.width / before.width)
      .toBeCloseTo(1.5, 1);
    const after = (await lowPass.boundingBox())!;
    expect(after.x - x).toBeCloseTo((before.x - x) * 1.5, -1);
    expect(await page.evaluate(() => visualViewport?.scale)).toBe(1);
  });

  await test.step('holding still asks for the menu', async () => {
    const now = (await lowPass.boundingBox())!;
    await fingers.hold({ x: now.x + now.width / 2, y: now.y + 20 }, () =>
      expect(graph.menu).toBeVisible(),
    );
    await expect(graph.menu).toBeVisible();
    await graph.menuItem('Bypass').tap();
    await expect(lowPass).toContainText('bypassed');
  });

  await test.step('several nodes are selected, and removed', async () => {
    const now = (await lowPass.boundingBox())!;
    await fingers.hold({ x: now.x + now.width / 2, y: now.y + 20 }, () =>
      expect(graph.menu).toBeVisible(),
    );
    await graph.menuItem('Select multiple').tap();
    await expect(page.getByText('1 selected.')).toBeVisible();
    const clock = (await graph.node('Module clock').boundingBox())!;
    await fingers.tap({ x: clock.x + clock.width / 2, y: clock.y + 20 });
    await expect(page.getByText('2 selected.')).toBeVisible();
    await page.getByRole('button', { name: 'Done' }).tap();
  });
});

test('a topic of the palette is dragged onto an input with a finger', async ({ room, master }) => {
  const wave = await room.program('wave');
  wave.publish('/wave/height', 'double', 4);
  const { page } = await room.atDesk('Ines', TABLET);
  const graph = new GraphPage({ page });
  const fingers = await Fingers.on(page);
  await graph.open(await aSession(master, 'low-pass'));
  const value = graph.socket('Module low-pass', 'Input value');
  await expect(value).toBeVisible();
  const topic = graph.paletteTopic('/wave/height');
  await expect(topic).toBeVisible();
  await fingers.drag(await middleOf(topic), await middleOf(value));
  await expect(value).toHaveAccessibleName(/1 connected/);
});

test('on a phone, a session that runs is touched below its list', async ({ room, master }) => {
  const { page } = await room.withPhone('Ines');
  const fingers = await Fingers.on(page);
  await page.goto(`/sessions/${await aSession(master, 'position-color')}/graph`);
  const list = page.getByRole('list', { name: 'Nodes of the graph' });
  const position = list.getByRole('button', { name: /^Input position/ });
  const pad = page.getByRole('application', { name: 'Touch pad' });

  await test.step('the pad opens with the start, and nothing is wrong', async () => {
    await position.tap();
    await page.getByRole('option', { name: /^touch_position/ }).tap();
    await list.getByRole('button', { name: /^Output color/ }).tap();
    await page.getByRole('combobox', { name: 'Find source or topic' }).fill('/colour');
    await page.getByRole('option', { name: 'New topic /colour' }).tap();
    await page.getByRole('button', { name: /^(Save and start|Start)$/ }).tap();
    await expect(pad).toBeVisible();
    await expect(pad).toContainText('Touch here');
    await expect(position).toContainText('not touched');
    await expect(page.getByRole('button', { name: /problem/ })).toBeHidden();
  });

  await test.step('a touch gives a colour', async () => {
    await fingers.tapOn(pad);
    await expect(position).toContainText('0.500, 0.500');
    await expect(pad).not.toContainText('Touch here');
    await expect(list.getByRole('button', { name: /^Output color/ })).toContainText(/\d\.\d \d/);
  });

  await test.step('the phone stays touchable in the graph view', async () => {
    await page.getByRole('button', { name: 'Show as a graph' }).tap();
    await expect(pad).toBeVisible();
    await expect(page.getByRole('group', { name: /touch_position/ }).first()).toContainText(
      '0.500',
    );
    await page.getByRole('button', { name: 'Show as a list' }).tap();
  });

  await test.step('a closed pad is no problem', async () => {
    await page.getByRole('button', { name: 'Close the pad' }).tap();
    await expect(pad).toBeHidden();
    await expect(position).toContainText('not touched');
    await expect(page.getByRole('button', { name: /problem/ })).toBeHidden();
  });
});

test('on a phone, modules are added, bound and started in the list', async ({ room, master }) => {
  const wave = await room.program('wave');
  wave.publish('/wave/height', 'double', 4);
  wave.publish('/wave/place', 'vector2', { x: 1, y: 2 });
  const { page } = await room.withPhone('Ines');
  await page.goto(`/sessions/${await aSession(master)}/graph`);
  const list = page.getByRole('list', { name: 'Nodes of the graph' });

  await test.step('a module is added', async () => {
    await page.getByRole('button', { name: 'Add', exact: true }).tap();
    await page.getByRole('combobox', { name: 'Add to the session' }).fill('low-pass');
    await page.getByRole('option', { name: /^low-pass / }).tap();
    await expect(list.getByRole('heading', { name: 'low-pass' })).toBeVisible();
  });

  const input = list.getByRole('button', { name: /^Input value/ });
  await test.step('what does not fit says why, and what would make it fit', async () => {
    await input.tap();
    await page.getByRole('option', { name: /^place \/wave / }).tap();
    const refusal = page.getByRole('dialog').getByRole('alert');
    await expect(refusal).toContainText('outputs vector2');
    await expect(refusal.getByRole('button', { name: 'Take x', exact: true })).toBeVisible();
    await refusal.getByRole('button', { name: 'Cancel' }).tap();
  });

  await test.step('what fits is read, and shows its value', async () => {
    await page.getByRole('option', { name: /^height \/wave / }).tap();
    await expect(page.getByRole('dialog')).toBeHidden();
    await expect(input).toContainText('/wave/height');
    await expect(input).toContainText('4.00');
  });

  await test.step('its output is led to a topic, it is started, and the value comes out', async () => {
    const output = list.getByRole('button', { name: /^Output smoothed/ });
    await output.tap();
    await page.getByRole('combobox', { name: 'Find source or topic' }).fill('/wave/smooth');
    await page.getByRole('option', { name: 'New topic /wave/smooth' }).tap();
    await expect(output).toContainText('/wave/smooth');
    await page.getByRole('button', { name: /^(Save and start|Start)$/ }).tap();
    await expect(page.getByRole('toolbar', { name: 'Session controls' })).toContainText('Running');
    wave.publish('/wave/height', 'double', 5);
    await expect(output).toContainText(/\d\.\d\d/);
  });

  await test.step('what is removed comes back', async () => {
    await page.getByRole('button', { name: 'Actions for low-pass' }).tap();
    await page.getByRole('menuitem', { name: 'Delete', exact: true }).tap();
    await expect(list.getByRole('heading', { name: 'low-pass' })).toBeHidden();
    await page.getByRole('button', { name: 'Undo', exact: true }).last().tap();
    await expect(list.getByRole('heading', { name: 'low-pass' })).toBeVisible();
  });
});
