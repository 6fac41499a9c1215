// @vitest-environment happy-dom
import type { DOMWrapper } from '@vue/test-utils';
import { afterEach, describe, expect, it } from 'vitest';
import SessionDetails from '../editor/session-menu/SessionDetails.vue';
import TextInspector from '../inspector/TextInspector.vue';
import ConstantInspector from '../inspector/ConstantInspector.vue';
import WireInspector from '../inspector/WireInspector.vue';
import { aModule } from '../model/testing/small-graph.ts';
import { addables } from './addable.ts';
import FrameNodeView from './nodes/FrameNodeView.vue';
import ModulePortRow from './nodes/ModulePortRow.vue';
import {
  aGraphDesk,
  FRAME,
  input,
  LOOSE,
  MIDDLE,
  NOTE,
  output,
  SINK,
  SOURCE,
  VALUE,
  type GraphDesk,
} from './testing/graph-desk.ts';

/** Something that is done to a graph, and how undo calls it. */
interface Deed {
  readonly does: string;
  readonly undo: RegExp;
  act(desk: GraphDesk): unknown;
}

const press =
  (nodes: readonly string[], ...keys: readonly string[]) =>
  (desk: GraphDesk): void =>
    desk.press(nodes, ...keys);

/** Presses the node at its middle, and drags it by this way. */
function dragNode(desk: GraphDesk, id: string, ...ways: readonly (readonly [number, number])[]) {
  const { x, y, width, height } = desk.boxOf(id);
  const middle = { x: x + width / 2, y: y + height / 2 };
  const places = ways.map(([right, down]) => ({ x: middle.x + right, y: middle.y + down }));
  desk.drag((event) => desk.canvas.drag.press(event, id), middle, ...places);
}

async function typeNumber(field: Omit<DOMWrapper<Element>, 'exists'>, text: string): Promise<void> {
  (field.element as HTMLInputElement).focus();
  await field.setValue(text);
  await field.trigger('keydown', { key: 'Enter' });
}

/** The words of an entry of the menu, which do not count here. */
const UNNAMED = { key: '', text: '', hint: '' };

const NODES: readonly Deed[] = [
  {
    does: 'adds a note by typing',
    undo: /^Add the comment$/,
    act({ adding, editor }) {
      const sources = { modules: [], topics: [] };
      const [note] = addables(editor.graph.value, sources, 'note', undefined);
      adding.askInMiddle();
      adding.choose(note!);
    },
  },
  { does: 'deletes a node', undo: /^Delete middle$/, act: press([MIDDLE], 'Delete') },
  {
    does: 'deletes a node and closes the gap',
    undo: /^Delete middle/,
    act: press([MIDDLE], 'Shift+Delete'),
  },
  { does: 'moves a node', undo: /^Move loose$/, act: (desk) => dragNode(desk, LOOSE, [90, 70]) },
  {
    does: 'moves a node by keys',
    undo: /^Move loose$/,
    act: press([LOOSE], 'Shift+ArrowRight', 'Control+Shift+ArrowDown'),
  },
  {
    does: 'lines nodes up by keys',
    undo: /^Move loose$/,
    act: press([LOOSE, SOURCE], 'Alt+a'),
  },
  {
    does: 'makes the gaps the same by keys',
    undo: /^Move /,
    act: press([SOURCE, LOOSE, SINK], 'Alt+Shift+v'),
  },
  {
    does: 'lines nodes up in the menu',
    undo: /^Move /,
    act: (desk) => desk.choose({ kind: 'nodes', nodes: [LOOSE, SINK] }, 'Top edges'),
  },
  { does: 'folds a node', undo: /^Collapse middle$/, act: press([MIDDLE], 'c') },
  { does: 'duplicates a node', undo: /^Duplicate a node$/, act: press([LOOSE], 'Control+d') },
  {
    does: 'copies and pastes nodes',
    undo: /^Paste a node$/,
    act(desk) {
      const clipboardData = new DataTransfer();
      desk.clipboard([LOOSE], 'copy', clipboardData);
      desk.clipboard([LOOSE], 'paste', clipboardData);
    },
  },
  {
    does: 'cuts a node',
    undo: /^Delete loose$/,
    act: (desk) => desk.clipboard([LOOSE], 'cut', new DataTransfer()),
  },
];

const WIRES: readonly Deed[] = [
  {
    does: 'pulls a wire',
    undo: /^Connect sink · result to loose · value$/,
    act: ({ canvas: { gesture } }) =>
      gesture.connect(output(SINK), input(LOOSE), { clientX: 0, clientY: 0 }),
  },
  {
    does: 'drags the end of a wire to another input',
    undo: /^Move a wire$/,
    act({ canvas: { gesture } }) {
      const socket = document.createElement('button');
      gesture.pressKey(input(MIDDLE), socket);
      gesture.pressKey(input(LOOSE), socket);
    },
  },
  {
    does: 'removes a wire',
    undo: /^Disconnect source · result from middle · value$/,
    act(desk) {
      desk.editor.selectWire(desk.wire(SOURCE, MIDDLE).id);
      desk.canvas.commands.remove(false);
    },
  },
  {
    does: 'disconnects a socket in the menu',
    undo: /^Disconnect/,
    act: (desk) => desk.choose({ kind: 'socket', port: input(MIDDLE) }, 'Disconnect'),
  },
  {
    does: 'leads a wire through a point',
    undo: /^Reroute a wire$|point/,
    act: (desk) => desk.canvas.commands.addPoint(desk.wire(SOURCE, MIDDLE).id),
  },
  {
    does: 'shows the topic of a wire as a node',
    undo: /^Show the topic \/a$/,
    act: (desk) =>
      desk.choose({ kind: 'wire', wire: desk.wire(SOURCE, MIDDLE).id }, 'Show topic as node'),
  },
  {
    does: 'renames the topic of a wire',
    undo: /^Change the topic of a wire to \/other$/,
    async act(desk) {
      const inspector = desk.view(WireInspector, { wire: desk.wire(SOURCE, MIDDLE) });
      await inspector.get('input').setValue('/other');
      await inspector.get('form').trigger('submit');
    },
  },
  {
    does: 'inserts a module of the menu on a wire',
    undo: /^Insert low-pass on a wire$/,
    act({ adding, ...desk }) {
      const module = aModule('low-pass', { value: 'double' }, { smoothed: 'double' });
      adding.askFor({ at: { x: 0, y: 0 }, end: undefined, wire: desk.wire(SOURCE, MIDDLE).id });
      adding.choose({ ...UNNAMED, item: { kind: 'module', module } });
    },
  },
  {
    does: 'inserts the node that lies on a wire',
    undo: /^Insert loose on a wire$/,
    act: (desk) => desk.canvas.commands.insertOn(desk.wire(SOURCE, MIDDLE).id, LOOSE),
  },
  {
    does: 'drops a node on a wire',
    undo: /^Insert loose on a wire$/,
    act(desk) {
      const [from, to] = [desk.boxOf(SOURCE), desk.boxOf(MIDDLE)];
      const { x, y, width, height } = desk.boxOf(LOOSE);
      const middle = { x: (from.x + from.width + to.x) / 2, y: 15 };
      dragNode(desk, LOOSE, [middle.x - x - width / 2, middle.y - y - height / 2]);
    },
  },
  { does: 'takes a node off its wires', undo: /^Detach middle$/, act: press([MIDDLE], 'x') },
  {
    does: 'shakes a node off its wires',
    undo: /middle/,
    act: (desk) =>
      dragNode(
        desk,
        MIDDLE,
        ...Array.from({ length: 8 }, (_, turn) => [turn % 2 === 0 ? 60 : -60, 120] as const),
        [0, 120],
      ),
  },
  {
    does: 'disconnects a node in the menu',
    undo: /^Disconnect 2 wires$/,
    act: (desk) => desk.choose({ kind: 'nodes', nodes: [MIDDLE] }, 'Disconnect all'),
  },
];

const SETTINGS: readonly Deed[] = [
  { does: 'bypasses a module', undo: /^Bypass middle$/, act: press([MIDDLE], 'b') },
  { does: 'mutes a module', undo: /^Mute middle$/, act: press([MIDDLE], 'm') },
  {
    does: 'types a value into an input',
    undo: /^Set value of loose$/,
    async act(desk) {
      const node = desk.node(LOOSE, 'module');
      const row = desk.view(ModulePortRow, { node, port: node.ports[0] });
      await typeNumber(row.get('input'), '4.5');
    },
  },
  {
    does: 'changes a value that stands alone',
    undo: /^Change Limit$/,
    async act(desk) {
      const inspector = desk.view(ConstantInspector, { node: desk.node(VALUE, 'constant') });
      await typeNumber(inspector.get('input[aria-label="Value"]'), '7');
    },
  },
  {
    does: 'renames a value, letter by letter',
    undo: /^Edit/,
    async act(desk) {
      const name = desk
        .view(ConstantInspector, { node: desk.node(VALUE, 'constant') })
        .get('input');
      await name.setValue('High');
      await name.setValue('Highest');
    },
  },
  {
    does: 'writes a note, letter by letter',
    undo: /^Edit the comment$/,
    async act(desk) {
      const text = desk.view(TextInspector, { node: desk.node(NOTE, 'comment') }).get('textarea');
      await text.setValue('See');
      await text.setValue('Seen');
    },
  },
  {
    does: 'describes the session, letter by letter',
    undo: /^Change the description of the session$/,
    async act(desk) {
      const text = desk.view(SessionDetails, {}).get('textarea');
      await text.setValue('What');
      await text.setValue('What it is for');
    },
  },
];

const FRAMES: readonly Deed[] = [
  { does: 'puts a frame around', undo: /^Frame loose$/, act: press([LOOSE], 'Control+g') },
  {
    does: 'puts a frame around a frame',
    undo: /^Frame the frame Box$/,
    act: press([FRAME], 'Control+g'),
  },
  {
    does: 'takes only the frame away',
    undo: /^Remove the frame$/,
    act: press([FRAME], 'Control+Shift+g'),
  },
  { does: 'moves a frame', undo: /^Move/, act: (desk) => dragNode(desk, FRAME, [40, 30]) },
  {
    does: 'resizes a frame',
    undo: /^Resize the frame$/,
    act(desk) {
      const { x, y, width, height } = desk.boxOf(FRAME);
      const corner = { x: x + width, y: y + height };
      desk.drag(
        (event) => desk.canvas.resize.press(event, desk.node(FRAME, 'frame'), { x: 1, y: 1 }),
        corner,
        { x: corner.x + 60, y: corner.y + 40 },
      );
    },
  },
  {
    does: 'resizes a frame by keys',
    undo: /^Resize/,
    act: press([FRAME], 'Control+ArrowRight', 'Control+ArrowRight'),
  },
  {
    does: 'drags a node into a frame',
    undo: /^Move loose into the frame Box$/,
    act(desk) {
      const [box, loose] = [desk.boxOf(FRAME), desk.boxOf(LOOSE)];
      dragNode(desk, LOOSE, [box.x + 20 - loose.x, box.y + 140 - loose.y]);
    },
  },
  {
    does: 'drags a node out of a frame',
    undo: /^Remove Limit from the frame$/,
    act: (desk) => dragNode(desk, VALUE, [0, 260]),
  },
  {
    does: 'colours a frame',
    undo: /^Colour the frame Box$/,
    act: (desk) =>
      desk
        .view(TextInspector, { node: desk.node(FRAME, 'frame') })
        .findAll('[role="group"] button')[2]!
        .trigger('click'),
  },
  {
    does: 'names a frame, letter by letter',
    undo: /^Edit the frame/,
    async act(desk) {
      const view = desk.view(FrameNodeView, { node: desk.node(FRAME, 'frame') });
      await view.get('.title').trigger('dblclick');
      const title = view.get('input');
      await title.setValue('Phone');
      await title.setValue('Phones');
      await title.trigger('keydown', { key: 'Enter' });
    },
  },
];

let desk: GraphDesk;
afterEach(() => desk.close());

describe.each([
  ['nodes', NODES],
  ['wires', WIRES],
  ['settings', SETTINGS],
  ['frames', FRAMES],
])('what is done to %s is undone and done again, each kind of it', (_about, deeds) => {
  it.each(deeds.map((deed) => [deed.does, deed] as const))('%s', async (_does, { undo, act }) => {
    desk = await aGraphDesk();
    const { editor } = desk;
    const before = editor.graph.value;
    await act(desk);
    const after = editor.graph.value;
    expect(after).not.toEqual(before);
    expect(editor.undoLabel.value).toMatch(undo);
    editor.undo();
    expect(editor.graph.value).toEqual(before);
    expect(editor.undoLabel.value).toBeUndefined();
    editor.redo();
    expect(editor.graph.value).toEqual(after);
    editor.redo();
    editor.undo();
    expect(editor.graph.value).toEqual(before);
  });
});
