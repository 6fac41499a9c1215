import type { Locator } from '@playwright/test';
import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage, type Place } from '../../pages/graph-page.ts';
import { pictureOf } from '../../pages/graph-picture.ts';

/** Something people do to a graph, with their hands, and how the way back is called. */
interface Deed {
  readonly does: string;
  readonly undo: RegExp;
  act(graph: GraphPage): Promise<void>;
}

const SOURCE = 'Module source';
const MIDDLE = 'Module middle';
const SINK = 'Module sink';
const LOOSE = 'Module loose';
const FRAME = 'Frame Box';
const NOTE = 'Note Watch this';
const VALUE = 'Value Limit';

const MODULES = {
  source: { x: 0, y: 0, writes: '/a' },
  middle: { x: 320, y: 0, reads: '/a', writes: '/b' },
  sink: { x: 640, y: 0, reads: '/b' },
  loose: { x: 320, y: 190 },
};
const OTHERS = {
  'frame:box': { kind: 'frame', title: 'Box', x: 0, y: 200, width: 240, height: 240 },
  'constant:limit': { kind: 'constant', name: 'Limit', json: '{"double":1}', x: 20, y: 250 },
  'comment:note': { kind: 'comment', text: 'Watch this', x: 660, y: 220 },
};

const press =
  (node: string, ...keys: readonly string[]) =>
  async (graph: GraphPage): Promise<void> => {
    await graph.node(node).focus();
    for (const key of keys) await graph.page.keyboard.press(key);
  };
const choose =
  (node: string, ...items: readonly string[]) =>
  async (graph: GraphPage): Promise<void> => {
    const { x, y } = await graph.grip(node);
    await graph.page.mouse.click(x, y, { button: 'right' });
    for (const [index, item] of items.entries()) {
      if (index < items.length - 1) await graph.menuItem(item).hover();
      else await graph.menuItem(item).click();
    }
  };
async function inspect(graph: GraphPage, node: string): Promise<Locator> {
  const { x, y } = await graph.grip(node);
  await graph.page.mouse.click(x, y);
  return graph.inspector;
}
const input = (graph: GraphPage, node: string): Locator => graph.socket(node, 'Input value');
const output = (graph: GraphPage, node: string): Locator => graph.socket(node, 'Output result');
const onFirstWire = (graph: GraphPage): Promise<Place> =>
  graph.between(output(graph, SOURCE), input(graph, MIDDLE));
async function dragBy(graph: GraphPage, from: Place, x: number, y: number): Promise<void> {
  await graph.pullBy(from, x, y);
  await graph.page.mouse.up();
}
async function selectAllOf(graph: GraphPage, ...nodes: readonly string[]): Promise<void> {
  await graph.page.keyboard.down('Shift');
  for (const node of nodes) {
    const { x, y } = await graph.grip(node);
    await graph.page.mouse.click(x, y);
  }
  await graph.page.keyboard.up('Shift');
}

const NODES: readonly Deed[] = [
  {
    does: 'drags a module in',
    undo: /^Add low-pass$/,
    act: async (graph) => graph.drag(graph.paletteModule('low-pass'), await graph.spot(0.8, 0.75)),
  },
  {
    does: 'adds a note by typing',
    undo: /^Add the comment$/,
    async act(graph) {
      await graph.canvas.focus();
      await graph.page.keyboard.press('a');
      const search = graph.page.getByRole('combobox', { name: 'Add to the graph' });
      await search.fill('note');
      await search.press('Enter');
    },
  },
  { does: 'deletes a node', undo: /^Delete middle$/, act: press(MIDDLE, 'Delete') },
  {
    does: 'deletes a node and closes the gap',
    undo: /^Delete middle/,
    act: press(MIDDLE, 'Shift+Delete'),
  },
  {
    does: 'moves a node',
    undo: /^Move loose$/,
    act: async (graph) => dragBy(graph, await graph.grip(LOOSE), 90, 70),
  },
  {
    does: 'moves a node by keys',
    undo: /^Move loose$/,
    act: press(LOOSE, 'Shift+ArrowRight', 'Control+Shift+ArrowDown'),
  },
  {
    does: 'lines nodes up by keys',
    undo: /^Move loose$/,
    async act(graph) {
      await selectAllOf(graph, LOOSE, SOURCE);
      await graph.page.keyboard.press('Alt+a');
    },
  },
  {
    does: 'makes the gaps the same by keys',
    undo: /^Move /,
    async act(graph) {
      await selectAllOf(graph, SOURCE, LOOSE, SINK);
      await graph.page.keyboard.press('Alt+Shift+v');
    },
  },
  {
    does: 'lines nodes up in the menu',
    undo: /^Move /,
    async act(graph) {
      await selectAllOf(graph, LOOSE, SINK);
      await choose(SINK, 'Align', 'Top edges')(graph);
    },
  },
  {
    does: 'arranges all',
    undo: /^Arrange all$/,
    act: (graph) => graph.page.getByRole('button', { name: 'Arrange all' }).click(),
  },
  { does: 'folds a node', undo: /^Collapse middle$/, act: press(MIDDLE, 'c') },
  { does: 'duplicates a node', undo: /^Duplicate a node$/, act: press(LOOSE, 'Control+d') },
  {
    does: 'copies and pastes nodes',
    undo: /^Paste a node$/,
    act: press(LOOSE, 'Control+c', 'Control+v'),
  },
  { does: 'cuts a node', undo: /^Delete loose$/, act: press(LOOSE, 'Control+x') },
];

const WIRES: readonly Deed[] = [
  {
    does: 'pulls a wire',
    undo: /^Connect sink · result to loose · value$/,
    act: (graph) => graph.dragTo(output(graph, SINK), input(graph, LOOSE)),
  },
  {
    does: 'pulls a wire to something new',
    undo: /^Connect sink · result to \/Placed\/result$/,
    async act(graph) {
      await graph.drag(output(graph, SINK), await graph.spot(0.85, 0.75));
      await graph.page.getByRole('combobox', { name: 'Connect to a new node' }).press('Enter');
    },
  },
  {
    does: 'drags the end of a wire to another input',
    undo: /^Connect source · result to loose · value$|^Move a wire$/,
    act: (graph) => graph.dragTo(input(graph, MIDDLE), input(graph, LOOSE)),
  },
  {
    does: 'removes a wire',
    undo: /^Disconnect \w+ · result from \w+ · value$/,
    async act(graph) {
      await graph.pointAtWire('left');
      await graph.page.keyboard.press('Delete');
    },
  },
  {
    does: 'disconnects a socket in the menu',
    undo: /^Disconnect/,
    async act(graph) {
      await input(graph, MIDDLE).click({ button: 'right' });
      await graph.menuItem('Disconnect').click();
    },
  },
  {
    does: 'leads a wire through a point',
    undo: /^Reroute a wire$|point/,
    async act(graph) {
      const { x, y } = await onFirstWire(graph);
      await graph.page.mouse.dblclick(x, y);
    },
  },
  {
    does: 'shows the topic of a wire as a node',
    undo: /^Show the topic \/[ab]$/,
    async act(graph) {
      await graph.pointAtWire('right');
      await graph.menuItem('Show topic as node').click();
    },
  },
  {
    does: 'renames the topic of a wire',
    undo: /^Change the topic of a wire to \/other$/,
    async act(graph) {
      await graph.pointAtWire('left');
      const field = graph.inspector.getByLabel('Topic', { exact: true });
      await field.fill('/other');
      await field.press('Enter');
    },
  },
  {
    does: 'drops a module on a wire',
    undo: /^Insert low-pass on a wire$/,
    act: async (graph) => graph.drag(graph.paletteModule('low-pass'), await onFirstWire(graph)),
  },
  {
    does: 'drops a node on a wire',
    undo: /^Insert loose on a wire$/,
    async act(graph) {
      const { width, height } = await graph.box(LOOSE);
      const middle = await onFirstWire(graph);
      const to = { x: middle.x - width / 2 + 40, y: middle.y - height / 2 + 14 };
      await graph.pull(await graph.grip(LOOSE), to);
      await graph.page.mouse.up();
    },
  },
  { does: 'takes a node off its wires', undo: /^Detach middle$/, act: press(MIDDLE, 'x') },
  {
    does: 'shakes a node off its wires',
    undo: /middle/,
    async act(graph) {
      const { mouse } = graph.page;
      const { x, y } = await graph.grip(MIDDLE);
      await mouse.move(x, y);
      await mouse.down();
      await expect(async () => {
        for (let turn = 0; turn < 8; turn += 1) {
          await mouse.move(x + (turn % 2 === 0 ? 60 : -60), y + 120);
        }
        await expect(graph.canvas.locator('[data-wire].loose')).toHaveCount(2, { timeout: 500 });
      }).toPass();
      await mouse.move(x, y + 120);
      await mouse.up();
    },
  },
  {
    does: 'disconnects a node in the menu',
    undo: /^Disconnect 2 wires$/,
    act: choose(MIDDLE, 'Disconnect all'),
  },
];

const SETTINGS: readonly Deed[] = [
  { does: 'bypasses a module', undo: /^Bypass middle$/, act: press(MIDDLE, 'b') },
  { does: 'mutes a module', undo: /^Mute middle$/, act: press(MIDDLE, 'm') },
  {
    does: 'types a value into an input',
    undo: /^Set value of loose$/,
    async act(graph) {
      const field = graph.value(LOOSE, 'value');
      await field.fill('4.5');
      await field.press('Enter');
    },
  },
  {
    does: 'changes a value that stands alone',
    undo: /^Change Limit$/,
    async act(graph) {
      const field = (await inspect(graph, VALUE)).getByRole('textbox', {
        name: 'Value',
        exact: true,
      });
      await field.fill('7');
      await field.press('Enter');
    },
  },
  {
    does: 'renames a value',
    undo: /^Edit/,
    act: async (graph) => (await inspect(graph, VALUE)).getByLabel('Name').fill('Highest'),
  },
  {
    does: 'changes when a module runs',
    undo: /^Change the mode of loose$/,
    async act(graph) {
      const mode = (await inspect(graph, LOOSE)).getByRole('radiogroup', {
        name: 'Processing mode',
      });
      await mode.getByRole('radio', { name: 'Lockstep' }).click();
    },
  },
  {
    does: 'changes where a module runs',
    undo: /^Change the place of loose$/,
    async act(graph) {
      await (await inspect(graph, LOOSE)).getByLabel('Where loose runs').click();
      await graph.page.getByRole('option').last().click();
    },
  },
  {
    does: 'writes a note',
    undo: /^Edit the comment$/,
    act: async (graph) => (await inspect(graph, NOTE)).getByRole('textbox').fill('Seen'),
  },
  {
    does: 'renames the session',
    undo: /^Change the name of the session$/,
    act: (graph) => graph.rename('Another'),
  },
  {
    does: 'describes the session',
    undo: /^Change the description of the session$/,
    act: (graph) => graph.describe('What it is for'),
  },
];

const FRAMES: readonly Deed[] = [
  { does: 'puts a frame around', undo: /^Frame loose$/, act: press(LOOSE, 'Control+g') },
  {
    does: 'puts a frame around a frame',
    undo: /^Frame the frame Box$/,
    act: press(FRAME, 'Control+g'),
  },
  {
    does: 'takes only the frame away',
    undo: /^Remove the frame$/,
    act: press(FRAME, 'Control+Shift+g'),
  },
  {
    does: 'moves a frame',
    undo: /^Move/,
    act: async (graph) => dragBy(graph, await graph.grip(FRAME), 40, 30),
  },
  {
    does: 'resizes a frame',
    undo: /^Resize the frame$/,
    async act(graph) {
      const corner = graph.node(FRAME).locator('[data-resize="se"]');
      await dragBy(graph, await graph.middleOf(corner), 60, 40);
    },
  },
  {
    does: 'resizes a frame by keys',
    undo: /^Resize/,
    act: press(FRAME, 'Control+ArrowRight'),
  },
  {
    does: 'drags a node into a frame',
    undo: /^Move loose into the frame Box$/,
    async act(graph) {
      const [box, loose] = [await graph.box(FRAME), await graph.grip(LOOSE)];
      await graph.pull(loose, { x: box.x + 60, y: box.y + box.height - 60 });
      await graph.page.mouse.up();
    },
  },
  {
    does: 'drags a node out of a frame',
    undo: /^Remove Limit from the frame$/,
    async act(graph) {
      const { x, y } = await graph.grip(VALUE);
      await dragBy(graph, { x, y }, 0, 260);
    },
  },
  {
    does: 'colours a frame',
    undo: /^Colour the frame Box$/,
    async act(graph) {
      const colors = (await inspect(graph, FRAME)).getByRole('group', {
        name: 'Colour of the frame',
      });
      await colors.getByRole('button').nth(2).click();
    },
  },
  {
    does: 'names a frame',
    undo: /^Edit the frame/,
    async act(graph) {
      const { x, y } = await graph.box(FRAME);
      await graph.page.mouse.dblclick(x + 20, y + 14);
      const title = graph.page.getByLabel('Title of the frame');
      await title.fill('Phones');
      await title.press('Enter');
    },
  },
];

for (const [about, deeds] of Object.entries({
  nodes: NODES,
  wires: WIRES,
  settings: SETTINGS,
  frames: FRAMES,
})) {
  test(`what is done to ${about} is undone and done again, each kind of it`, async ({
    room,
    master,
  }) => {
    // Many small steps, each of which waits for what is drawn.
    test.slow();
    const anna = await room.atDesk('Anna');
    await anna.context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const graph = new GraphPage(anna);
    const inBox = { ...OTHERS['constant:limit'], frame: 'frame:box' };
    await graph.open(await placedSession(master, MODULES, { ...OTHERS, 'constant:limit': inBox }));
    await expect(graph.node(NOTE)).toBeVisible();
    await expect(graph.canvas.locator('[data-wire]')).toHaveCount(2);
    const { keyboard } = anna.page;
    const undo = anna.page.getByRole('button', { name: /^Undo: / });
    const first = await pictureOf(graph);

    for (const { does, undo: label, act } of deeds) {
      await test.step(does, async () => {
        await act(graph);
        await expect.poll(() => pictureOf(graph), does).not.toBe(first);
        await expect
          .poll(async () => (await undo.getAttribute('aria-label'))?.slice(6))
          .toMatch(label);
        // Undo in a field affects its text: focus the canvas.
        await graph.canvas.focus();
        await expect.poll(async () => settled(graph)).toBe(true);
        const done = await pictureOf(graph);
        await keyboard.press('Control+z');
        await expect.poll(() => pictureOf(graph), `${does}, undone`).toBe(first);
        await keyboard.press('Control+y');
        await expect.poll(() => pictureOf(graph), `${does}, done again`).toBe(done);
        await keyboard.press('Control+Shift+z');
        await keyboard.press('Control+z');
        await expect.poll(() => pictureOf(graph), `${does}, undone again`).toBe(first);
        await keyboard.press('Escape');
      });
    }
  });
}

/** True when nothing changes from one frame to the next. */
async function settled(graph: GraphPage): Promise<boolean> {
  const before = await pictureOf(graph);
  await graph.page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  return before === (await pictureOf(graph));
}
