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

test('a wire is led through points with the mouse, and every step is undone', async ({
  room,
  master,
}) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const { mouse, keyboard } = anna.page;
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

test('a wire is led through points with the keyboard alone', async ({ room, master }) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const { keyboard } = anna.page;
  const status = graph.canvas.getByRole('status').filter({ hasText: 'Wire from' });

  await graph.node('Module source').focus();
  await keyboard.press('w');
  await expect(status).toHaveText('Wire from source · result to sink · value');
  await keyboard.press('p');
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

test('points move along when both ends of their wire do', async ({ room, master }) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const { mouse, keyboard } = anna.page;
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

test('a node is dropped on a wire, and taken off again', async ({ room, master }) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const { mouse, keyboard } = anna.page;
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
    await expect(graph.socket('Module loose', 'Input value')).toHaveAccessibleName(/not connected/);
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

test('something from the palette is dropped on a wire', async ({ room, master }) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const wires = graph.canvas.locator('[data-wire]');
  await graph.drag(graph.paletteModule('low-pass'), await wirePlace(graph));
  await expect(wires).toHaveCount(2);
  await expect(graph.socket('Module low-pass', 'Input value')).toHaveAccessibleName(/1 connected/);
  await anna.page.keyboard.press('Control+z');
  await expect(wires).toHaveCount(1);
  await expect(graph.node('Module low-pass')).toBeHidden();
});

test('a frame is made, takes nodes in, lets them go, and is resized', async ({ room, master }) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const { mouse, keyboard } = anna.page;
  const frame = graph.node('Frame');
  const area = frame.locator('[data-over]');

  await test.step('around what is selected', async () => {
    await graph.node('Module loose').focus();
    await keyboard.press('Control+g');
    await expect(frame).toBeVisible();
  });

  await test.step('what is in it moves along', async () => {
    const before = await graph.box('Module loose');
    await graph.pullBy(await graph.grip('Frame'), -60, 0);
    await mouse.up();
    await expect
      .poll(async () => (await graph.box('Module loose')).x - before.x)
      .toBeCloseTo(-60, -1);
  });

  await test.step('its corner makes it larger', async () => {
    const { width } = await graph.box('Frame');
    const corner = await graph.middleOf(frame.locator('[data-resize="se"]'));
    await graph.pullBy(corner, 260, 80);
    await mouse.up();
    await expect.poll(async () => (await graph.box('Frame')).width - width).toBeCloseTo(260, -1);
  });

  await test.step('a node dropped in it joins, and moves along', async () => {
    const { x, y, width, height } = await graph.box('Frame');
    const node = await graph.box('Module sink');
    const to = { x: x + width - node.width + 20, y: y + height - node.height - 10 };
    await graph.pull(await graph.grip('Module sink'), to);
    await expect(area).toHaveCount(1);
    await mouse.up();
    await expect(area).toHaveCount(0);
    const joined = await graph.box('Module sink');
    await graph.pullBy(await graph.grip('Frame'), 0, -40);
    await mouse.up();
    await expect
      .poll(async () => (await graph.box('Module sink')).y - joined.y)
      .toBeCloseTo(-40, -1);
  });

  await test.step('and leaves it when it is dragged out', async () => {
    await graph.pullBy(await graph.grip('Module sink'), 20, -260);
    await mouse.up();
    const left = await graph.box('Module sink');
    const before = await graph.box('Frame');
    await graph.pullBy(await graph.grip('Frame'), 0, 40);
    await mouse.up();
    await expect.poll(async () => (await graph.box('Frame')).y - before.y).toBeCloseTo(40, -1);
    expect((await graph.box('Module sink')).y).toBeCloseTo(left.y, 0);
  });

  await test.step('it has a title of its own', async () => {
    const { x, y } = await graph.box('Frame');
    await mouse.dblclick(x + 24, y + 14);
    await anna.page.getByLabel('Title of the frame').fill('Phones');
    await keyboard.press('Enter');
    await expect(graph.node('Frame Phones')).toContainText('Phones');
    await keyboard.press('Control+z');
    await expect(frame).toBeVisible();
  });

  await test.step('without it, what was in it stays', async () => {
    await keyboard.press('Control+Shift+g');
    await expect(frame).toBeHidden();
    await expect(graph.node('Module loose')).toBeVisible();
  });
});

test('nodes line up with others, and thin lines say so', async ({ room, master }) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna, { ...FLOW, loose: { x: 353, y: 207 } });
  const { mouse, keyboard } = anna.page;
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

test('the canvas is moved and zoomed by keys and by the middle button', async ({
  room,
  master,
}) => {
  const anna = await room.atDesk('Anna');
  const { graph } = await openFlow(master, anna);
  const { mouse, keyboard } = anna.page;
  const before = await graph.box('Module source');
  const moved = async (): Promise<number> => (await graph.box('Module source')).x - before.x;

  await graph.node('Module source').focus();
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

test('what lies far away is titles and wires, and nothing moves when it comes near', async ({
  room,
  master,
}) => {
  const anna = await room.atDesk('Anna');
  const topic = { kind: 'topic', x: 350, y: 60 };
  const spread = { ...FLOW, away: { x: 9000, y: 4000 } };
  const id = await placedSession(master, spread, { 'topic:/flow': topic });
  const graph = new GraphPage(anna);
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
  await anna.page.keyboard.press('f');
  await expect(graph.canvas.locator('.graph-stage.far')).toBeAttached();
  await expect(sockets).toHaveCount(8);
  expect(await drawn()).toEqual(near);

  await graph.node('Module away').focus();
  await anna.page.keyboard.press('2');
  await expect(graph.socket('Module away', 'Input value')).toBeVisible();
  await expect(sockets).toHaveCount(10);
});

test('a node that somebody else removes in the middle of a drag is let go of', async ({
  room,
  master,
}) => {
  const anna = await room.atDesk('Anna');
  const ben = await room.atDesk('Ben');
  const { graph, id } = await openFlow(master, anna);
  const others = new GraphPage(ben);
  await others.open(id);
  const before = await graph.box('Module sink');

  await graph.node('Module sink').focus();
  await anna.page.keyboard.press('Control+a');
  await graph.pullBy(await graph.grip('Module loose'), 40, 40);

  await others.node('Module loose').focus();
  await ben.page.keyboard.press('Delete');
  await others.life.getByRole('button', { name: 'Save 1 change' }).click();
  await expect(graph.node('Module loose')).toBeHidden();

  await test.step('the others are where they were, and go on', async () => {
    await anna.page.mouse.move(700, 500);
    await anna.page.mouse.up();
    await expect.poll(async () => (await graph.box('Module sink')).x).toBeCloseTo(before.x, -1);
    await expect(graph.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
    await graph.pullBy(await graph.grip('Module sink'), -50, 100);
    await anna.page.mouse.up();
    await expect
      .poll(async () => (await graph.box('Module sink')).x - before.x)
      .toBeCloseTo(-50, -1);
    await graph.life.getByRole('button', { name: 'Save 1 change' }).click();
    await expect(graph.life.getByRole('button', { name: /^Save(?! and)/ })).toBeHidden();
  });
});
