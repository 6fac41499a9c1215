import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { CanvasContext } from './useCanvas.ts';
import type { Point, PortRef } from '../model/graph.ts';
import type { Alignment, Axis } from '../model/selection/arrange.ts';
import { duplicate } from '../model/selection/clipboard.ts';
import { collapseCommand } from '../nodes/collapse.ts';
import type { KeyWalk } from './keys/key-walk.ts';
import { viewKey } from './view-keys.ts';
import { goToEnd, walkWires } from './wire-walk.ts';

/** Actions of keys that do not edit the graph. */
export interface CanvasActions {
  fit(): void;
  add(): void;
  find(): void;
  /** @returns whether there was something to cancel */
  cancel(): boolean;
  open(node: string): void;
  showProblem(): void;
  /** Starts a wire at a socket and opens the list of fitting ends. */
  connect(port: PortRef): void;
  /** Announces why a key had no effect. */
  tell(sentence: string): void;
}

/** State and commands that the key handlers use. */
export interface CanvasKeys extends Pick<CanvasContext, 'stage' | 'commands' | 'points'> {
  readonly editor: GraphEditor;
  readonly actions: CanvasActions;
  readonly walk: KeyWalk;
}

const STEP = 10;
const BIG_STEP = 40;
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};
/** With Alt, matched by `event.code`: on some keyboard layouts Alt changes the letter. */
const ALIGN: Readonly<Record<string, Alignment>> = {
  KeyA: 'left',
  KeyD: 'right',
  KeyW: 'top',
  KeyS: 'bottom',
  KeyH: 'center',
  KeyV: 'middle',
};
const SPREAD: Readonly<Record<string, Axis>> = { KeyH: 'x', KeyV: 'y' };

/** Runs the command of a key. @returns whether it has one */
export function canvasKey(keys: CanvasKeys, event: KeyboardEvent): boolean {
  const arrow = ARROWS[event.key];
  if (event.ctrlKey || event.metaKey) {
    if (arrow === undefined) return commandKey(keys, event);
    if (event.shiftKey) return keys.commands.move(scaled(arrow, BIG_STEP));
    return keys.commands.resize(scaled(arrow, STEP));
  }
  if (event.altKey) return alignKey(keys, event);
  if (arrow !== undefined) return arrowKey(keys, arrow, event);
  return plainKey(keys, event) || viewKey(keys.stage, keys.editor, keys.actions, event);
}

const scaled = ({ x, y }: Point, by: number): Point => ({ x: x * by, y: y * by });

/** Moves the focus between nodes, sockets and wires; with Shift, moves the selection. */
function arrowKey(keys: CanvasKeys, arrow: Point, { shiftKey, target }: KeyboardEvent): boolean {
  const { editor, commands, points, stage, walk } = keys;
  const { wire } = editor.selection.value;
  if (points.selected !== undefined)
    return commands.move(scaled(arrow, shiftKey ? BIG_STEP : STEP));
  if (shiftKey) return commands.move(scaled(arrow, STEP));
  if (wire !== undefined) {
    if (arrow.x !== 0) return goToEnd(editor, walk, wire, arrow.x > 0 ? 'to' : 'from');
    return walkWires(editor, stage, arrow.y > 0 ? 1 : -1);
  }
  return walk.arrow(target as HTMLElement, arrow);
}

function plainKey(keys: CanvasKeys, event: KeyboardEvent): boolean {
  const { editor, commands, points, actions, stage, walk } = keys;
  const target = event.target as HTMLElement;
  const { nodes, wire } = editor.selection.value;
  switch (event.key) {
    case 'Delete':
    case 'Backspace':
      // Shift connects the sources of the nodes to their targets.
      return commands.remove(event.shiftKey);
    case 'Escape':
      if (points.selected !== undefined) points.select(undefined);
      else if (!actions.cancel() && !walk.leaveSocket(target)) editor.select([]);
      return true;
    case 'l': {
      const port = walk.socketFor(target);
      if (port === undefined) actions.tell('Focus a node or a socket first, then press L.');
      else actions.connect(port);
      return true;
    }
    case 'Enter': {
      const [only] = nodes;
      if (only === undefined) return false;
      actions.open(only);
      return true;
    }
    case 'c':
      return collapse(editor);
    case 'b':
      return toggleStanding(editor, 'bypassed');
    case 'm':
      return toggleStanding(editor, 'muted');
    case 'x':
      return commands.detach();
    case 'i':
      if (!commands.insert()) actions.tell('The node is not on a compatible wire.');
      return true;
    case 'w':
    case 'W':
      return walkWires(editor, stage, event.shiftKey ? -1 : 1);
    case 'p':
      actions.showProblem();
      return true;
    case 'r':
      if (wire === undefined) return false;
      commands.addPoint(wire);
      return true;
    case ']':
      return points.walk(1);
    case '[':
      return points.walk(-1);
    case 'Tab':
      // For mouse users with the focus on the canvas; see keys/tab-stops.ts for the keyboard.
      if (event.shiftKey || nodes.size > 0) return false;
      actions.add();
      return true;
    case 'Insert':
    case 'a':
      actions.add();
      return true;
    default:
      return false;
  }
}

function alignKey({ commands }: CanvasKeys, { code, shiftKey }: KeyboardEvent): boolean {
  const axis = shiftKey ? SPREAD[code] : undefined;
  if (axis !== undefined) return commands.distribute(axis);
  const alignment = shiftKey ? undefined : ALIGN[code];
  return alignment !== undefined && commands.align(alignment);
}

/** Collapses the selected nodes to headers, or expands them. */
function collapse(editor: GraphEditor): boolean {
  const { nodes } = editor.graph.value;
  const chosen = [...editor.selection.value.nodes].flatMap((id) => nodes.get(id) ?? []);
  const command = collapseCommand(chosen);
  if (command !== undefined) editor.apply(command);
  return command !== undefined;
}

/** Bypasses or mutes the selected modules, or enables them when all are in that state. */
function toggleStanding(editor: GraphEditor, standing: 'bypassed' | 'muted'): boolean {
  const modules = [...editor.selection.value.nodes].flatMap((id) => {
    const node = editor.graph.value.nodes.get(id);
    return node?.kind === 'module' ? [node] : [];
  });
  if (modules.length === 0) return false;
  const isOn = modules.every((node) => node.standing === standing);
  editor.apply({
    kind: 'setStanding',
    nodes: modules.map(({ id }) => id),
    standing: isOn ? 'active' : standing,
  });
  return true;
}

function commandKey(
  { editor, commands, actions }: CanvasKeys,
  { key, shiftKey }: KeyboardEvent,
): boolean {
  switch (key.toLowerCase()) {
    case 'z':
      if (shiftKey) editor.redo();
      else editor.undo();
      return true;
    case 'y':
      editor.redo();
      return true;
    case 'a':
      editor.select(editor.graph.value.nodes.keys());
      return true;
    case 'f':
      actions.find();
      return true;
    case 'g':
      // Handled even without a frame, to suppress the browser's shortcut.
      if (shiftKey) commands.unframe();
      else commands.frame();
      return true;
    case 'd': {
      const copy = duplicate(editor.graph.value, editor.selection.value.nodes, randomUuid);
      if (copy === undefined) return true;
      editor.apply(copy.command);
      editor.select(copy.ids);
      return true;
    }
    default:
      return false;
  }
}
