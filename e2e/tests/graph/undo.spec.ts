import type { Locator } from '@playwright/test';
import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';
import { pictureOf } from '../../pages/graph-picture.ts';

/** Something people do to a graph, with their hands, and how the way back is called. */
interface Deed {
  readonly does: string;
  readonly undo: RegExp;
  act(graph: GraphPage): Promise<void>;
}

const SINK = 'Module sink';
const LOOSE = 'Module loose';
const NOTE = 'Note Watch this';

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

async function press(graph: GraphPage, node: string, ...keys: readonly string[]): Promise<void> {
  await graph.node(node).focus();
  for (const key of keys) await graph.page.keyboard.press(key);
}
async function inspect(graph: GraphPage, node: string): Promise<Locator> {
  const { x, y } = await graph.grip(node);
  await graph.page.mouse.click(x, y);
  return graph.inspector;
}

/** What takes a pointer, a layout or the clipboard of a browser; all other actions are in `canvas/undo.test.ts`. */
const DEEDS: readonly Deed[] = [
  {
    does: 'drags a module in',
    undo: /^Add low-pass$/,
    act: async (graph) => graph.drag(graph.paletteModule('low-pass'), await graph.spot(0.8, 0.75)),
  },
  {
    does: 'moves a node',
    undo: /^Move loose$/,
    async act(graph) {
      await graph.pullBy(await graph.grip(LOOSE), 90, 70);
      await graph.page.mouse.up();
    },
  },
  {
    does: 'copies and pastes nodes',
    undo: /^Paste a node$/,
    act: (graph) => press(graph, LOOSE, 'Control+c', 'Control+v'),
  },
  {
    does: 'arranges all',
    undo: /^Arrange all$/,
    act: (graph) => graph.chooseTool('Arrange all'),
  },
  {
    does: 'pulls a wire to something new',
    undo: /^Connect sink · result to \/Placed\/result$/,
    async act(graph) {
      await graph.drag(graph.socket(SINK, 'Output result'), await graph.spot(0.85, 0.75));
      await graph.page.getByRole('combobox', { name: 'Connect to a new node' }).press('Enter');
    },
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
    does: 'renames the session',
    undo: /^Change the name of the session$/,
    act: (graph) => graph.rename('Another'),
  },
];

test('what is done with pointers, keys and fields is undone and done again', async ({
  room,
  master,
}) => {
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

  for (const { does, undo: label, act } of DEEDS) {
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

/** True when nothing changes from one frame to the next. */
async function settled(graph: GraphPage): Promise<boolean> {
  const before = await pictureOf(graph);
  await graph.page.evaluate(() => new Promise((done) => requestAnimationFrame(done)));
  return before === (await pictureOf(graph));
}
