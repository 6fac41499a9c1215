import type { MasterProcess } from '@ubii/harness';
import { placedSession, type PlacedModule } from '../../fixtures/placed-session.ts';
import { expect, test, type Person } from '../../fixtures/test.ts';
import { GraphPage, type Place } from '../../pages/graph-page.ts';

/** From left to right; nothing is wired to the third one, which lies below. */
const FLOW: Readonly<Record<string, PlacedModule>> = {
  source: { x: 0, y: 0, writes: '/flow' },
  sink: { x: 700, y: 0, reads: '/flow' },
  loose: { x: 350, y: 300 },
};

async function openFlow(
  master: MasterProcess,
  person: Person,
  modules = FLOW,
): Promise<{ graph: GraphPage; id: string }> {
  const id = await placedSession(master, modules);
  const graph = new GraphPage(person);
  await graph.open(id);
  for (const name of Object.keys(modules)) await expect(graph.node(`Module ${name}`)).toBeVisible();
  return { graph, id };
}

const wirePlace = (graph: GraphPage): Promise<Place> =>
  graph.between(
    graph.socket('Module source', 'Output result'),
    graph.socket('Module sink', 'Input value'),
  );

test('wires and nodes are edited on the canvas with mouse and keyboard', async ({
  room,
  master,
}) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const { mouse, keyboard } = anna.page;
  await test.step('a wire is led through points with the mouse, and every step is undone', async () => {
    const point = graph.points.first();
    const middle = await wirePlace(graph);

    await test.step('a double-click adds one', async () => {
      await mouse.dblclick(middle.x, middle.y);
      await expect(graph.points).toHaveCount(1);
    });

    await test.step('it is dragged', async () => {
      const from = await graph.middleOf(point);
      await graph.pullBy(from, 0, 120);
      await mouse.up();
      await expect.poll(async () => (await graph.middleOf(point)).y - from.y).toBeCloseTo(120, -1);
    });

    await test.step('a wire that is dragged is bent there', async () => {
      const from = await graph.middleOf(graph.socket('Module sink', 'Input value'));
      await graph.pullBy({ x: from.x - 24, y: from.y + 2 }, -60, -60);
      await mouse.up();
      await expect(graph.points).toHaveCount(2);
    });

    await test.step('undo and redo go one by one', async () => {
      const dragged = await graph.middleOf(point);
      await keyboard.press('Control+z');
      await expect(graph.points).toHaveCount(1);
      await keyboard.press('Control+z');
      await expect
        .poll(async () => (await graph.middleOf(point)).y - dragged.y)
        .toBeCloseTo(-120, -1);
      await keyboard.press('Control+z');
      await expect(graph.points).toHaveCount(0);
      await keyboard.press('Control+y');
      await expect(graph.points).toHaveCount(1);
      await keyboard.press('Control+y');
      await expect.poll(async () => (await graph.middleOf(point)).y - dragged.y).toBeCloseTo(0, -1);
    });

    await test.step('a drag that Escape ends was none', async () => {
      const from = await graph.middleOf(point);
      await graph.pullBy(from, 80, 80);
      await keyboard.press('Escape');
      await mouse.up();
      await expect.poll(async () => (await graph.middleOf(point)).y - from.y).toBeCloseTo(0, -1);
    });

    await test.step('a double-click on it takes it away', async () => {
      const at = await graph.middleOf(point);
      await mouse.dblclick(at.x, at.y);
      await expect(graph.points).toHaveCount(0);
      await keyboard.press('Control+z');
      await expect(graph.points).toHaveCount(1);
    });
  });

  await graph.startAgain();
  await test.step('a wire is led through points with the keyboard alone', async () => {
    const status = graph.canvas.getByRole('status').filter({ hasText: 'Wire from' });

    await graph.node('Module source').focus();
    await keyboard.press('w');
    await expect(status).toHaveText('Wire from source · result to sink · value');
    await keyboard.press('r');
    await expect(graph.points).toHaveCount(1);
    await expect(status).toContainText('point 1 of 1');

    const before = await graph.middleOf(graph.points.first());
    await keyboard.press('Shift+ArrowDown');
    await keyboard.press('Shift+ArrowDown');
    await expect
      .poll(async () => (await graph.middleOf(graph.points.first())).y - before.y)
      .toBeGreaterThan(40);
    await keyboard.press('Control+z');
    await expect
      .poll(async () => (await graph.middleOf(graph.points.first())).y - before.y)
      .toBeCloseTo(0, -1);
    await keyboard.press('Delete');
    await expect(graph.points).toHaveCount(0);

    await test.step('and an arrow goes on to the node at its end', async () => {
      await keyboard.press('ArrowRight');
      await expect(graph.node('Module sink')).toBeFocused();
    });
  });

  await graph.startAgain();
  await test.step('points move along when both ends of their wire do', async () => {
    const middle = await wirePlace(graph);
    await mouse.dblclick(middle.x, middle.y);
    const before = await graph.middleOf(graph.points.first());
    await graph.node('Module source').focus();
    await keyboard.press('Control+a');
    await graph.pullBy(await graph.grip('Module source'), 50, 60);
    await mouse.up();
    await expect
      .poll(async () => (await graph.middleOf(graph.points.first())).y - before.y)
      .toBeCloseTo(60, -1);
    await keyboard.press('Control+z');
    await expect
      .poll(async () => (await graph.middleOf(graph.points.first())).y - before.y)
      .toBeCloseTo(0, -1);
  });

  await graph.startAgain();
  await test.step('a node is dropped on a wire, and taken off again', async () => {
    const loose = graph.node('Module loose');
    const wires = graph.canvas.locator('[data-wire]');
    await expect(wires).toHaveCount(1);

    await test.step('the wire lights up, and leads through the node', async () => {
      const { width, height } = await graph.box('Module loose');
      const middle = await wirePlace(graph);
      const to = { x: middle.x - width / 2 + 40, y: middle.y - height / 2 + 14 };
      await graph.pull(await graph.grip('Module loose'), to);
      await expect(wires.first()).toHaveClass(/target/);
      await mouse.up();
      await expect(wires).toHaveCount(2);
      await expect(graph.socket('Module loose', 'Input value')).toHaveAccessibleName(/1 connected/);
    });

    await test.step('as one step', async () => {
      await keyboard.press('Control+z');
      await expect(wires).toHaveCount(1);
      await expect.poll(async () => (await graph.box('Module loose')).y).toBeGreaterThan(300);
      await keyboard.press('Control+y');
      await expect(wires).toHaveCount(2);
    });

    await test.step('with Alt it comes off, and the wire closes', async () => {
      await keyboard.down('Alt');
      await graph.pullBy(await graph.grip('Module loose'), 0, 250);
      await mouse.up();
      await keyboard.up('Alt');
      await expect(wires).toHaveCount(1);
      await expect(graph.socket('Module loose', 'Input value')).toHaveAccessibleName(
        /not connected/,
      );
      await keyboard.press('Control+z');
      await expect(wires).toHaveCount(2);
    });

    await test.step('with X, too', async () => {
      await loose.focus();
      await keyboard.press('x');
      await expect(wires).toHaveCount(1);
      await expect(loose).toBeVisible();
    });
  });

  await graph.startAgain();
  await test.step('something from the palette is dropped on a wire', async () => {
    const wires = graph.canvas.locator('[data-wire]');
    await graph.drag(graph.paletteModule('low-pass'), await wirePlace(graph));
    await expect(wires).toHaveCount(2);
    await expect(graph.socket('Module low-pass', 'Input value')).toHaveAccessibleName(
      /1 connected/,
    );
    await keyboard.press('Control+z');
    await expect(wires).toHaveCount(1);
    await expect(graph.node('Module low-pass')).toBeHidden();
  });

  await graph.startAgain();
  await test.step('a wire is made with the keyboard alone', async () => {
    await graph.socket('Module source', 'Output result').focus();
    await keyboard.press('Enter');
    await graph.socket('Module loose', 'Input value').focus();
    await keyboard.press('Enter');
    await expect(graph.socket('Module loose', 'Input value')).toHaveAccessibleName(/1 connected/);

    await test.step('and nodes are moved and removed with it', async () => {
      const node = graph.node('Module loose');
      await node.focus();
      const before = await node.boundingBox();
      await keyboard.press('Shift+ArrowDown');
      await expect.poll(async () => (await node.boundingBox())!.y - before!.y).toBeGreaterThan(5);
      await keyboard.press('Delete');
      await expect(node).toBeHidden();
      await keyboard.press('Control+z');
      await expect(node).toBeVisible();
    });
  });
});

test('the canvas is moved and zoomed, and draws what is near and lines up', async ({
  room,
  master,
}) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna, { ...FLOW, loose: { x: 353, y: 207 } });
  const { mouse, keyboard } = anna.page;
  await test.step('nodes line up with others, and thin lines say so', async () => {
    const guides = graph.canvas.locator('[data-guide]');
    const source = await graph.box('Module source');
    const loose = await graph.box('Module loose');
    const grip = await graph.grip('Module loose');
    await graph.pull(grip, { x: grip.x + source.x - loose.x + 3, y: grip.y + 30 });
    await expect(guides).not.toHaveCount(0);
    await expect.poll(async () => (await graph.box('Module loose')).x).toBeCloseTo(source.x, 0);

    await keyboard.down('Alt');
    await mouse.move(grip.x + source.x - loose.x + 4, grip.y + 34);
    await expect(guides).toHaveCount(0);
    await keyboard.up('Alt');
    await mouse.up();
    await expect(guides).toHaveCount(0);

    await test.step('from afar, too', async () => {
      for (let step = 0; step < 5; step += 1) await keyboard.press('-');
      await expect.poll(async () => (await graph.box('Module source')).width).toBeLessThan(70);
      const [from, to] = [await graph.box('Module loose'), await graph.box('Module source')];
      const head = { x: from.x + from.width / 2, y: from.y + 5 };
      await graph.pull(head, { x: head.x + to.x - from.x + 2, y: head.y + 20 });
      await expect.poll(() => guides.evaluateAll((lines) => lines.length)).toBeGreaterThan(0);
      expect(await guides.first().evaluate((line) => line.checkVisibility())).toBe(true);
      await mouse.up();
    });
  });

  await graph.startAgain();
  await test.step('the canvas is moved and zoomed by keys and by the middle button', async () => {
    await graph.fitBesideInspector('Module source');
    const before = await graph.box('Module source');
    const moved = async (): Promise<number> => (await graph.box('Module source')).x - before.x;

    await keyboard.press('-');
    await expect
      .poll(async () => (await graph.box('Module source')).width)
      .toBeLessThan(before.width);
    await keyboard.press('Home');
    await expect.poll(moved).toBeCloseTo(0, 0);

    const grip = await graph.grip('Module source');
    await keyboard.down(' ');
    await graph.pullBy(grip, 70, 0);
    await mouse.up();
    await keyboard.up(' ');
    await expect.poll(moved).toBeCloseTo(70, 0);

    await mouse.move(grip.x + 70, grip.y);
    await mouse.down({ button: 'middle' });
    await mouse.move(grip.x, grip.y, { steps: 3 });
    await mouse.up({ button: 'middle' });
    await expect.poll(moved).toBeCloseTo(0, 0);
  });

  await test.step('what lies far away is titles and wires, and nothing moves when it comes near', async () => {
    const topic = { kind: 'topic', x: 350, y: 60 };
    const spread = { ...FLOW, away: { x: 9000, y: 4000 } };
    const id = await placedSession(master, spread, { 'topic:/flow': topic });
    await graph.open(id);
    const drawn = () =>
      graph.canvas.evaluate((canvas) => ({
        wires: [...canvas.querySelectorAll('[data-wire] > .line')].map((line) =>
          line.getAttribute('d'),
        ),
        nodes: [...canvas.querySelectorAll<HTMLElement>('[data-graph-node]')].map(
          ({ offsetWidth, offsetHeight }) => `${offsetWidth} ${offsetHeight}`,
        ),
      }));
    await expect.poll(async () => (await drawn()).wires.length).toBe(2);
    const sockets = graph.canvas.locator('[data-port]');
    // It opens where values begin. What is away is not made: two modules and the topic between them are.
    await expect(graph.socket('Module sink', 'Input value')).toBeVisible();
    await expect(sockets).toHaveCount(8);
    const near = await drawn();

    await graph.node('Module source').focus();
    await keyboard.press('f');
    await expect(graph.canvas.locator('.graph-stage.far')).toBeAttached();
    await expect(sockets).toHaveCount(8);
    expect(await drawn()).toEqual(near);

    await graph.node('Module away').focus();
    await keyboard.press('2');
    await expect(graph.socket('Module away', 'Input value')).toBeVisible();
    await expect(sockets).toHaveCount(10);
  });

  await test.step('thousands of topics are a tree of which only what is seen is drawn', async () => {
    const many = await room.program('many');
    const names = Array.from({ length: 3000 }, (_, at) => `/many/group-${at % 30}/topic-${at}`);
    for (const name of names) many.publish(name, 'double', 1);
    await graph.open(await placedSession(master, {}));
    const tree = graph.palette.getByRole('treegrid', { name: 'Topics' });
    const count = graph.palette.getByRole('heading', { name: /^Topics/ });
    await expect(count).toContainText('3000');
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
});
