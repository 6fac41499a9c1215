import { fromJson } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { defineComponent, effectScope, h, provide, ref, shallowRef, type Component } from 'vue';
import { CONNECTION, type Connection } from '../../../connection/connection.ts';
import { fakeTopics } from '../../../connection/live/testing/fake-topics.ts';
import { createShell, SHELL } from '../../../page/shell.ts';
import { createGraphEditor, type GraphEditor } from '../../editing/graph-editor.ts';
import type { LiveGraph } from '../../live/live-graph.ts';
import { GRAPH_CONTEXT, NOTHING_PENDING } from '../../live/useGraphContext.ts';
import type { OwnPad } from '../../live/own-pad.ts';
import { provideNoProblems } from '../../live/useGraphProblems.ts';
import type { GraphNode, Point, PortRef, Wire } from '../../model/graph.ts';
import { aModule, aSessionOf } from '../../model/testing/small-graph.ts';
import { drawnSize } from '../../nodes/drawn-size.ts';
import { CanvasCommands } from '../canvas-commands.ts';
import { canvasKey, type CanvasActions } from '../canvas-keys.ts';
import { CanvasStage } from '../canvas-stage.ts';
import { ConnectGesture } from '../connect-gesture.ts';
import { InsertTarget } from '../drag/insert-target.ts';
import { NodeDrag } from '../drag/node-drag.ts';
import { NodeResize } from '../frames/node-resize.ts';
import { useAdding, type Adding } from '../useAdding.ts';
import { KeyWalk } from '../keys/key-walk.ts';
import type { MenuAction, MenuPlace, MenuTarget } from '../menu/menu-entry.ts';
import { menuOf } from '../menu/menu-of.ts';
import { useGraphClipboard } from '../useGraphClipboard.ts';
import { WirePoints } from '../points/wire-points.ts';
import { CANVAS_CONTEXT, type CanvasContext } from '../useCanvas.ts';

export const SOURCE = 'module:source';
export const MIDDLE = 'module:middle';
export const SINK = 'module:sink';
export const LOOSE = 'module:loose';
export const FRAME = 'frame:box';
export const VALUE = 'constant:limit';
export const NOTE = 'comment:note';

/** source → middle → sink, and a module without wires; a value in a frame, and a note. */
function sessionOfDesk() {
  const io = { value: 'double' };
  const modules = ['source', 'middle', 'sink', 'loose'].map((name) =>
    aModule(name, io, { result: 'double' }),
  );
  const session = aSessionOf(modules, {
    'source.result': '/a',
    'middle.value': '/a',
    'middle.result': '/b',
    'sink.value': '/b',
  });
  const nodes = {
    [SOURCE]: { kind: 'module', x: 0, y: 0 },
    [MIDDLE]: { kind: 'module', x: 320, y: 0 },
    [SINK]: { kind: 'module', x: 640, y: 0 },
    [LOOSE]: { kind: 'module', x: 320, y: 190 },
    [FRAME]: { kind: 'frame', title: 'Box', x: 0, y: 200, width: 240, height: 240 },
    [VALUE]: {
      kind: 'constant',
      name: 'Limit',
      json: '{"double":1}',
      x: 20,
      y: 250,
      frame: FRAME,
    },
    [NOTE]: { kind: 'comment', text: 'Watch this', x: 660, y: 220 },
  };
  const editorJson = JSON.stringify({ format: 'ubi-interact.graph', version: 1, nodes });
  const { extension } = fromJson('ubii.sessions.Session', { extension: { editorJson } });
  return { ...session, extension };
}

/** Commands of one graph without the layout of a browser: keys, menus, pointers, fields. */
export interface GraphDesk {
  readonly editor: GraphEditor;
  readonly stage: CanvasStage;
  readonly canvas: CanvasContext;
  readonly adding: Adding;
  /** Presses keys while nodes are selected: `Control+Shift+ArrowDown`. */
  press(nodes: readonly string[], ...keys: readonly string[]): void;
  /** Chooses an entry of the context menu. */
  choose(target: MenuTarget, text: string): void;
  /** Copies, cuts or pastes as the keys of the browser do. */
  clipboard(
    nodes: readonly string[],
    what: 'copy' | 'cut' | 'paste',
    clipboardData: DataTransfer,
  ): void;
  /** Drags by places on the canvas, in canvas units, after `start` took the pointer. */
  drag(start: (event: PointerEvent) => void, from: Point, ...to: readonly Point[]): void;
  /** Mounts a view of a node or a wire. */
  view(component: Component, props: object): ReturnType<typeof mount>;
  wire(from: string, to: string): Wire;
  boxOf(node: string): Point & { readonly width: number; readonly height: number };
  node<K extends GraphNode['kind']>(id: string, kind: K): Extract<GraphNode, { kind: K }>;
  close(): void;
}

export async function aGraphDesk(): Promise<GraphDesk> {
  let count = 0;
  const uuid = (): string => `uuid-${(count += 1)}`;
  const editor = createGraphEditor(sessionOfDesk(), uuid);
  const host = document.body.appendChild(document.createElement('div'));
  const stage = new CanvasStage(host);
  // Here, a pan that ends would reject the promise of its animation.
  Object.assign(host.firstElementChild!, { animate: undefined });
  await stage.show(editor.places.value);
  for (const [id, node] of editor.graph.value.nodes) stage.sizes.set(id, drawnSize(node));
  const points = new WirePoints(editor, stage);
  const target = new InsertTarget(stage);
  const canvas: CanvasContext = {
    stage,
    points,
    target,
    gesture: new ConnectGesture(editor, stage, () => []),
    drag: new NodeDrag(editor, stage, target),
    resize: new NodeResize(editor, stage),
    commands: new CanvasCommands(editor, stage, points),
    walk: new KeyWalk(editor, stage),
    isFresh: ref(false),
  };
  const boxOf: GraphDesk['boxOf'] = (id) => stage.boxes([id])[0]!;
  const actions: CanvasActions = {
    fit() {},
    add() {},
    find() {},
    open() {},
    showProblem() {},
    connect() {},
    tell() {},
    cancel: () => false,
  };
  const place: MenuPlace = {
    at: { x: 0, y: 0 },
    boxOf,
    spotOn: () => undefined,
    uuid,
    isTouch: false,
  };
  const scope = effectScope();
  scope.run(() => useGraphClipboard(ref(host), editor));
  const showAll = (): Promise<void> => stage.fit();
  const adding = useAdding(
    ref(host),
    editor,
    stage,
    canvas.gesture,
    canvas.walk,
    showAll,
    () => {},
  );
  return {
    editor,
    stage,
    canvas,
    adding,
    boxOf,
    press(nodes, ...keys) {
      editor.select(nodes);
      for (const key of keys) canvasKey({ ...canvas, editor, actions }, keyEvent(key));
    },
    choose(on, text) {
      const all = menuOf(editor.graph.value, on, place).flatMap((entry): readonly MenuAction[] => {
        if (entry.kind === 'separator') return [];
        return entry.kind === 'group' ? entry.entries : [entry];
      });
      const entry = all.find((one) => one.text === text);
      if (entry?.command === undefined) throw new Error(`no entry ${text}`);
      editor.apply(entry.command);
    },
    clipboard(nodes, what, clipboardData) {
      editor.select(nodes);
      host.tabIndex = 0;
      host.focus();
      document.dispatchEvent(new ClipboardEvent(what, { clipboardData }));
    },
    close() {
      scope.stop();
      stage.destroy();
      host.remove();
    },
    drag(start, from, ...to) {
      start(pointer('pointerdown', from, 0));
      for (const [index, at] of to.entries()) {
        window.dispatchEvent(pointer('pointermove', at, 16 * (index + 1)));
      }
      window.dispatchEvent(pointer('pointerup', to.at(-1) ?? from, 16 * (to.length + 1)));
    },
    view(component, props) {
      const parent = defineComponent({
        setup() {
          provide(GRAPH_CONTEXT, {
            editor,
            live: NOTHING_LIVE,
            pad: NO_PAD,
            pending: NOTHING_PENDING,
            apply() {},
          });
          provide(CANVAS_CONTEXT, canvas);
          provide(SHELL, createShell());
          provide(CONNECTION, aConnection());
          provideNoProblems();
          return () => h(component, props);
        },
      });
      return mount(parent, { attachTo: host, global: { stubs: { RouterLink: true } } });
    },
    wire(from, to) {
      const found = [...editor.graph.value.wires.values()].find(
        (wire) => wire.from.node === from && wire.to.node === to,
      );
      if (found === undefined) throw new Error(`no wire from ${from} to ${to}`);
      return found;
    },
    node<K extends GraphNode['kind']>(id: string, kind: K) {
      const node = editor.graph.value.nodes.get(id);
      if (node?.kind !== kind) throw new Error(`no ${kind} ${id}`);
      return node as Extract<GraphNode, { kind: K }>;
    },
  };
}

export const input = (node: string): PortRef => ({ node, port: 'in:value' });
export const output = (node: string): PortRef => ({ node, port: 'out:result' });

/** A connection on which nothing is published. */
function aConnection(): Connection {
  const connection = {
    client: fakeTopics().client,
    isConnected: ref(true),
    master: { view: shallowRef() },
    masterId: shallowRef(''),
    clients: { list: shallowRef([]), find: () => undefined },
    topics: {
      rates: shallowRef(new Map()),
      masterTimeMs: shallowRef(0),
      watch: () => undefined,
      onChanges: () => undefined,
    },
  };
  return connection as unknown as Connection;
}

const NO_PAD = {} as OwnPad;
const NOTHING_LIVE = {
  isMoving: shallowRef(false),
  isPaused: shallowRef(false),
  isInView: shallowRef(() => true),
  topic: () => undefined,
  module: () => undefined,
  has: () => false,
  runTimes: () => [],
  events: ref([]),
} as unknown as LiveGraph;

function keyEvent(keys: string): KeyboardEvent {
  const parts = keys.split('+');
  const key = parts.at(-1)!;
  return new KeyboardEvent('keydown', {
    key,
    code: `Key${key.toUpperCase()}`,
    ctrlKey: parts.includes('Control'),
    shiftKey: parts.includes('Shift'),
    altKey: parts.includes('Alt'),
  });
}

function pointer(type: string, { x, y }: Point, timeStamp: number): PointerEvent {
  const event = new PointerEvent(type, {
    pointerId: 1,
    pointerType: 'mouse',
    button: 0,
    clientX: x,
    clientY: y,
  });
  // A shake has to take less than a second
  Object.defineProperty(event, 'timeStamp', { value: timeStamp });
  return event;
}
