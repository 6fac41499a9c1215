import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

/** A client that is not there any more. */
const GONE = 'b0c47f3b-1111-4222-8333-444455556666';

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

test('what flows in a session is set and seen on its nodes and wires', async ({ room, master }) => {
  const graph = new GraphPage(await room.atDesk('Anna'));
  const wave = await room.program('wave');
  await test.step('a value in the row of a node changes what runs, and what is typed wrong says so [PM-34]', async () => {
    const timer = setInterval(() => wave.publish('/wave/height', 'double', 4), 50);
    const id = await aSession(master, {
      name: 'Tide',
      processingModules: [
        { id: 'gate', name: 'threshold' },
        { id: 'soft', name: 'low-pass' },
      ],
      ioMappings: [
        {
          processingModuleId: 'gate',
          inputMappings: [{ inputName: 'value', topic: '/wave/height' }],
          outputMappings: [{ outputName: 'isAbove', topic: '/wave/high' }],
        },
        {
          processingModuleId: 'soft',
          inputMappings: [{ inputName: 'value', topic: '/wave/height' }],
        },
      ],
    });
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
      await expect(graph.node('Module threshold').getByRole('alert')).toContainText(
        'Enter a number',
      );
      await limit.press('Escape');
      await expect(graph.node('Module threshold').getByRole('alert')).toBeHidden();
    });

    await test.step('a new value counts at once', async () => {
      await limit.click();
      await limit.fill('10');
      await limit.press('Enter');
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

  await test.step('what passes a wire is seen where the pointer rests', async () => {
    let count = 0;
    const timer = setInterval(() => wave.publish('/wave/height', 'double', (count += 1)), 100);
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

  await test.step('a muxer is edited until it matches, and tells whom it gathers [PM-41] [PM-43]', async () => {
    const [ann, bob] = [await room.program('Ann'), await room.program('Bob')];
    const timer = setInterval(() => {
      for (const one of [ann, bob])
        one.publish(`/${one.id}/phone/touch`, 'vector2', { x: 1, y: 2 });
    }, 100);
    await graph.drag(graph.palettePart('Muxer'), await graph.spot(0.5, 0.85));
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
});

test('what is wrong with modules and topics, and where modules run, is on their nodes', async ({
  room,
  master,
}) => {
  const graph = new GraphPage(await room.atDesk('Anna'));
  await test.step('problems stand where they are: at nodes, at topics and on wires', async () => {
    const at = { frequency: { hertz: 5 } };
    const id = await aSession(master, {
      name: 'Trouble',
      processingModules: [
        { id: 'a', name: 'low-pass', processingMode: at },
        { id: 'b', name: 'map-range', processingMode: at },
        { id: 'c', name: 'statistics', processingMode: at },
        {
          id: 'd',
          name: 'thrower',
          processingMode: at,
          onProcessingStringified: "() => {\n  throw new Error('no model');\n}",
        },
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
    await graph.open(id);
    await expect(graph.problems('Module low-pass')).toHaveAccessibleName(/are connected in a loop/);
    await expect(graph.problems('Module map-range')).toHaveAccessibleName(
      /are connected in a loop/,
    );
    await expect(graph.problems('Topic /loop/b')).toHaveAccessibleName(/the last record wins/);
    await graph.problems('Topic /loop/b').click();
    await expect(graph.page.getByRole('dialog', { name: /1 problem/ })).toContainText(
      'the last record wins',
    );
  });

  await test.step('a node that is dropped on a module runs it', async () => {
    await graph.page.keyboard.press('Escape');
    await room.node('Lab PC');
    await graph.dragTo(graph.paletteHost('Lab PC'), graph.node('Module low-pass'));
    const place = graph.inspector.getByRole('combobox', { name: 'Where low-pass runs' });
    await expect(place).toContainText('Lab PC');
    await graph.life.getByRole('button', { name: 'Save 1 change' }).click();
    await expect(graph.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
    await graph.life.getByRole('button', { name: 'Start' }).click();
    await expect(graph.life).toContainText('Running');
    await graph.paletteHost('Lab PC').click();
    await expect(graph.palette.getByRole('button', { name: 'low-pass', exact: true })).toHaveCount(
      2,
    );

    await test.step('dropped beside modules it says what it is for', async () => {
      await graph.drag(graph.paletteHost('Lab PC'), await graph.spot(0.1, 0.2));
      await expect(
        graph.page.getByText('Drop this node on a module to run the module there.'),
      ).toBeVisible();
    });
  });

  await test.step('a module that fails says so on its node, with the line', async () => {
    await expect(graph.node('Module thrower')).toContainText('no model');
    await expect(graph.node('Module thrower')).toContainText('onProcessing:2');
  });

  await test.step('a topic of a client that has left is replaced by that of another client with one button', async () => {
    const { page } = graph;
    const robot = await room.program('Robot');
    robot.publish(`/${robot.id}/arm/angle`, 'double', 1.5);
    const id = await placedSession(master, {
      reader: { x: 400, y: 200, reads: `/${GONE}/arm/angle` },
    });
    await graph.open(id);
    const problems = page.getByRole('button', { name: '1 problem', exact: true });
    await problems.click();
    const list = graph.inspector.getByRole('list', { name: 'Problems' });
    await expect(list).toContainText(
      'Topic "arm/angle" has no value: its client Client b0c47f3b has left. Robot publishes the same topic.',
    );
    await list.getByRole('button', { name: 'Use angle of Robot' }).click();
    await expect(problems).toBeHidden();
    await expect(graph.life.getByRole('button', { name: /1 change/ })).toBeVisible();
    await page.getByRole('button', { name: 'Undo' }).click();
    await expect(problems).toBeVisible();
    await page.getByRole('button', { name: 'Redo' }).click();
    await expect(problems).toBeHidden();
  });

  await test.step('a module that nobody has any more is a placeholder that says what to do', async () => {
    const registered = await callService(master.endpoints, {
      topic: SERVICES.clientRegistration.topic,
      client: { name: 'lab', processingModules: [{ name: 'gaze-at-home' }] },
    });
    const client = registered.client!;
    const id = await aSession(master, {
      name: 'Pose',
      processingModules: [{ id: 'pose', name: 'gaze-at-home' }],
    });
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
});
