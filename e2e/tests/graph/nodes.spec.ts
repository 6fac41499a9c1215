import type { MasterProcess } from '@ubii/harness';
import { Image2DDataFormat, SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

type SessionInit = NonNullable<Parameters<typeof callService>[1]['session']>;

async function aSession(master: MasterProcess, session: SessionInit): Promise<string> {
  const reply = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session,
  });
  expect(reply.error?.message).toBeUndefined();
  return reply.session!.id;
}

/** The master asks nodes and the library every few seconds. */
const LISTS = { timeout: 20_000 };

test('a value in the row of a node changes what runs, and what is typed wrong says so [PM-34]', async ({
  room,
  master,
}) => {
  const wave = await room.program('wave');
  const timer = setInterval(() => wave.publish('/wave/height', 'double', 4), 50);
  const id = await aSession(master, {
    name: 'Tide',
    processingModules: [{ id: 'gate', name: 'threshold' }],
    ioMappings: [
      {
        processingModuleId: 'gate',
        inputMappings: [{ inputName: 'value', topic: '/wave/height' }],
        outputMappings: [{ outputName: 'isAbove', topic: '/wave/high' }],
      },
    ],
  });
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(id);
  const high = graph.node('Topic /wave/high');
  await graph.life.getByRole('button', { name: 'Start' }).click();
  await expect(high).toContainText('true');

  const limit = graph.value('Module threshold', 'threshold');
  await test.step('the inspector says what the value means [PM-6]', async () => {
    await graph.node('Module threshold').click();
    await expect(graph.inspector.getByRole('group', { name: 'Input threshold' })).toContainText(
      'The number counts as above from this value on.',
    );
  });
  await test.step('what is no number is told beside the field', async () => {
    await limit.click();
    await limit.fill('high');
    await expect(graph.node('Module threshold').getByRole('alert')).toContainText('Enter a number');
    await limit.press('Escape');
    await expect(graph.node('Module threshold').getByRole('alert')).toBeHidden();
  });

  await test.step('a new value counts at once when it is applied', async () => {
    await limit.click();
    await limit.fill('10');
    await limit.press('Enter');
    await graph.life.getByRole('button', { name: 'Apply 1 change' }).click();
    await expect(high).toContainText('false');
  });

  await test.step('it is undone as one step', async () => {
    await graph.page.getByRole('button', { name: /^Undo/ }).click();
    await expect(limit).toHaveValue('');
  });

  await test.step('it is dragged, too', async () => {
    const box = (await limit.boundingBox())!;
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await graph.page.mouse.move(x, y);
    await graph.page.mouse.down();
    await graph.page.mouse.move(x + 40, y, { steps: 5 });
    await graph.page.mouse.up();
    await expect.poll(async () => Number(await limit.inputValue())).toBeGreaterThan(0.5);
  });
  clearInterval(timer);
});

test('a muxer is edited until it matches, and tells whom it gathers [PM-41] [PM-43]', async ({
  room,
  master,
}) => {
  const [ann, bob] = [await room.program('Ann'), await room.program('Bob')];
  const timer = setInterval(() => {
    for (const one of [ann, bob]) one.publish(`/${one.id}/phone/touch`, 'vector2', { x: 1, y: 2 });
  }, 100);
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(await aSession(master, { name: 'Gather' }));
  await graph.drag(graph.palettePart('Muxer'), await graph.spot(0.4, 0.4));
  const muxer = graph.node('Muxer');
  await expect(muxer).toContainText('no pattern yet');

  const pattern = graph.inspector.getByRole('textbox', { name: 'Pattern', exact: true });
  const matches = graph.inspector.getByRole('list', { name: 'Matches now' });
  await pattern.fill('/*/nothing');
  await expect(graph.inspector).toContainText('No topic matches the pattern.');
  await pattern.fill('/*/phone/*');
  await expect(matches.getByRole('listitem')).toHaveCount(2);
  await expect(matches).toContainText('Ann');
  await expect(muxer).toContainText('Ann');
  await expect(muxer).toContainText('Bob');

  await test.step('an expression that cannot be used says why', async () => {
    await graph.inspector.getByRole('radio', { name: 'Regular expression' }).click();
    const expression = graph.inspector.getByRole('textbox', { name: 'Regular expression' });
    await expression.fill('phone(');
    await expect(graph.inspector).toContainText('The pattern cannot be used');
    await expression.fill('phone/touch$');
    await expect(matches.getByRole('listitem')).toHaveCount(2);
  });
  clearInterval(timer);
});

test('a topic with pictures shows them on its node', async ({ room, master }) => {
  const camera = await room.program('camera');
  const [width, height] = [32, 24];
  const data = new Uint8Array(width * height * 3);
  for (let at = 0; at < data.length; at += 3) data[at] = 200;
  const picture = { width, height, dataFormat: Image2DDataFormat.RGB8, data };
  const timer = setInterval(() => camera.publish('/cam/image', 'image2D', picture), 100);
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(await aSession(master, { name: 'Look' }));
  await graph.drag(graph.paletteTopic('/cam/image'), await graph.spot(0.4, 0.4));
  const shown = graph.node('Topic /cam/image').getByRole('img', { name: 'The newest picture' });
  await expect(shown).toBeVisible();
  await expect
    .poll(() =>
      shown.evaluate((canvas) => {
        const { width: w, height: h } = canvas as HTMLCanvasElement;
        const context = (canvas as HTMLCanvasElement).getContext('2d')!;
        return [...context.getImageData(w / 2, h / 2, 1, 1).data];
      }),
    )
    .toEqual([200, 0, 0, 255]);
  await expect(graph.inspector.getByRole('img', { name: 'The newest picture' })).toBeVisible();
  clearInterval(timer);
});

test('what passes a wire is seen where the pointer rests', async ({ room, master }) => {
  const wave = await room.program('wave');
  let count = 0;
  const timer = setInterval(() => wave.publish('/wave/height', 'double', (count += 1)), 100);
  const id = await aSession(master, {
    name: 'Tide',
    processingModules: [{ id: 'soft', name: 'low-pass' }],
    ioMappings: [
      {
        processingModuleId: 'soft',
        inputMappings: [{ inputName: 'value', topic: '/wave/height' }],
      },
    ],
  });
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(id);
  await expect(graph.node('Topic /wave/height')).toContainText('.00');
  await expect(graph.passing).toBeHidden();
  await graph.socket('Module low-pass', 'Input value').hover();
  await expect(graph.passing).toContainText('/wave/height');
  await expect(graph.passing.getByRole('listitem')).toHaveCount(10);
  await expect(graph.passing).toContainText('Hz');
  await graph.page.mouse.move(5, 5);
  await expect(graph.passing).toBeHidden();
  clearInterval(timer);
});

test('a module that nobody has any more is a placeholder that says what to do', async ({
  room,
  master,
}) => {
  const registered = await callService(master.endpoints, {
    topic: SERVICES.clientRegistration.topic,
    client: { name: 'lab', processingModules: [{ name: 'gaze-at-home' }] },
  });
  const client = registered.client!;
  const id = await aSession(master, {
    name: 'Pose',
    processingModules: [{ id: 'pose', name: 'gaze-at-home' }],
  });
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(id);
  const pose = graph.node('Module gaze-at-home');
  await expect(pose).toBeVisible();
  await callService(master.endpoints, {
    topic: SERVICES.clientDeregistration.topic,
    client: { id: client.id },
  });
  await expect(pose).toContainText('No node has this module', LISTS);
  await pose.click({ position: { x: 60, y: 12 } });
  await expect(graph.inspector).toContainText('The module "gaze-at-home" is unknown');
  await expect(graph.inspector.getByRole('link', { name: 'Import this module' })).toBeVisible();
});

test('a node that is dropped on a module runs it', async ({ room, master }) => {
  await room.node('Lab PC');
  const id = await aSession(master, {
    name: 'Place',
    processingModules: [{ id: 'soft', name: 'low-pass' }],
  });
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(id);
  await graph.dragTo(graph.paletteHost('Lab PC'), graph.node('Module low-pass'));
  const place = graph.inspector.getByRole('combobox', { name: 'Where low-pass runs' });
  await expect(place).toContainText('Lab PC');
  await graph.life.getByRole('button', { name: 'Save 1 change' }).click();
  await expect(graph.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
  await graph.life.getByRole('button', { name: 'Start' }).click();
  await expect(graph.life).toContainText('Running');
  await graph.paletteHost('Lab PC').click();
  await expect(graph.palette.getByRole('button', { name: 'low-pass', exact: true })).toHaveCount(2);

  await test.step('dropped beside modules it says what it is for', async () => {
    await graph.drag(graph.paletteHost('Lab PC'), await graph.spot(0.1, 0.2));
    await expect(
      graph.page.getByText('Drop this node on a module to run the module there.'),
    ).toBeVisible();
  });
});

test('problems stand where they are: at nodes, at topics and on wires', async ({
  room,
  master,
}) => {
  const at = { frequency: { hertz: 5 } };
  const id = await aSession(master, {
    name: 'Trouble',
    processingModules: [
      { id: 'a', name: 'low-pass', processingMode: at },
      { id: 'b', name: 'map-range', processingMode: at },
      { id: 'c', name: 'statistics', processingMode: at },
    ],
    ioMappings: [
      {
        processingModuleId: 'a',
        inputMappings: [{ inputName: 'value', topic: '/loop/b' }],
        outputMappings: [{ outputName: 'smoothed', topic: '/loop/a' }],
      },
      {
        processingModuleId: 'b',
        inputMappings: [{ inputName: 'value', topic: '/loop/a' }],
        outputMappings: [{ outputName: 'mapped', topic: '/loop/b' }],
      },
      {
        processingModuleId: 'c',
        outputMappings: [{ outputName: 'mean', topic: '/loop/b' }],
      },
    ],
  });
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(id);
  await expect(graph.problems('Module low-pass')).toHaveAccessibleName(/are connected in a loop/);
  await expect(graph.problems('Module map-range')).toHaveAccessibleName(/are connected in a loop/);
  await expect(graph.problems('Topic /loop/b')).toHaveAccessibleName(/the last record wins/);
  await graph.problems('Topic /loop/b').click();
  await expect(graph.page.getByRole('dialog', { name: /1 problem/ })).toContainText(
    'the last record wins',
  );
});

test('thousands of topics are a tree of which only what is seen is drawn', async ({
  room,
  master,
}) => {
  const many = await room.program('many');
  const names = Array.from({ length: 3000 }, (_, at) => `/many/group-${at % 30}/topic-${at}`);
  for (const name of names) many.publish(name, 'double', 1);
  const graph = new GraphPage(await room.atDesk('Anna'));
  await graph.open(await aSession(master, { name: 'Many' }));
  const tree = graph.palette.getByRole('treegrid', { name: 'Topics' });
  const count = graph.palette.getByRole('heading', { name: /^Topics/ });
  await expect(count).toContainText('3000', LISTS);
  expect(await tree.getByRole('row').count()).toBeLessThan(80);

  await test.step('a search finds one of them, which goes into the graph by keyboard', async () => {
    await graph.palette.getByRole('searchbox').fill('topic-2345');
    await expect(count).toContainText('1 of 3000');
    const row = graph.paletteTopic('/many/group-5/topic-2345');
    await expect(row).toContainText('1.00');
    await tree.getByRole('row').first().focus();
    await graph.page.keyboard.press('ArrowDown');
    await graph.page.keyboard.press('ArrowDown');
    await expect(row).toBeFocused();
    await graph.page.keyboard.press('Enter');
    await expect(graph.node('Topic /many/group-5/topic-2345')).toBeVisible();
  });

  await test.step('a branch is a muxer of all that is below it', async () => {
    await graph.drag(
      graph.palette.locator('[data-palette-branch="/many/group-5"]'),
      await graph.spot(0.5, 0.7),
    );
    await expect(graph.node('Muxer group-5')).toContainText('/many/group-5/**');
    await expect(graph.node('Muxer group-5')).toContainText('and 97 more');
  });
});
