import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editor/graph-editor.ts';
import type { CanvasContext } from '../editor/use-graph-editor.ts';
import type { Point } from '../model/graph.ts';
import type { Alignment, Axis } from '../model/selection/arrange.ts';
import { duplicate } from '../model/selection/clipboard.ts';
import { collapseCommand } from './collapse.ts';
import { viewKey } from './view-keys.ts';
import { goToEnd, walkWires } from './wire-walk.ts';

/** What keys do besides editing the graph. */
export interface CanvasActions {
  fit(): void;
  add(): void;
  find(): void;
  cancel(): void;
  open(node: string): void;
}

/** What keys work on. */
export interface CanvasKeys extends Pick<CanvasContext, 'stage' | 'commands' | 'points'> {
  readonly editor: GraphEditor;
  readonly actions: CanvasActions;
}

const STEP = 10;
const BIG_STEP = 40;
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};
/** With Alt, by the place of the key: on some keyboards Alt gives other letters. */
const ALIGN: Readonly<Record<string, Alignment>> = {
  KeyA: 'left',
  KeyD: 'right',
  KeyW: 'top',
  KeyS: 'bottom',
  KeyH: 'center',
  KeyV: 'middle',
};
const SPREAD: Readonly<Record<string, Axis>> = { KeyH: 'x', KeyV: 'y' };

/** Does what a key asks for. @returns true when it was one of ours */
export function canvasKey(keys: CanvasKeys, event: KeyboardEvent): boolean {
  const arrow = ARROWS[event.key];
  if (event.ctrlKey || event.metaKey) {
    if (arrow === undefined) return commandKey(keys, event);
    return keys.commands.resize(scaled(arrow, STEP));
  }
  if (event.altKey) return alignKey(keys, event);
  if (arrow !== undefined) return arrowKey(keys, arrow, event.shiftKey);
  return plainKey(keys, event) || viewKey(keys.stage, keys.editor, keys.actions, event);
}

const scaled = ({ x, y }: Point, by: number): Point => ({ x: x * by, y: y * by });

/** Moves what is selected; from a wire, goes to its ends and to the wires beside it. */
function arrowKey({ editor, commands, points, stage }: CanvasKeys, arrow: Point, isBig: boolean) {
  const { nodes, wire } = editor.selection.value;
  const way = scaled(arrow, isBig ? BIG_STEP : STEP);
  if (nodes.size > 0 || points.selected !== undefined) return commands.move(way);
  if (wire !== undefined) {
    if (arrow.x !== 0) return goToEnd(editor, stage, wire, arrow.x > 0 ? 'to' : 'from');
    return walkWires(editor, stage, arrow.y > 0 ? 1 : -1);
  }
  void stage.pan(scaled(way, -4));
  return true;
}

function plainKey({ editor, commands, points, actions, stage }: CanvasKeys, event: KeyboardEvent) {
  const { nodes, wire } = editor.selection.value;
  switch (event.key) {
    case 'Delete':
    case 'Backspace':
      // With Shift, what fed the nodes feeds what they fed.
      return commands.remove(event.shiftKey);
    case 'Escape':
      if (points.selected === undefined) actions.cancel();
      else points.select(undefined);
      return true;
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
      return commands.insert();
    case 'w':
    case 'W':
      return walkWires(editor, stage, event.shiftKey ? -1 : 1);
    case 'p':
      if (wire === undefined) return false;
      commands.addPoint(wire);
      return true;
    case ']':
      return points.walk(1);
    case '[':
      return points.walk(-1);
    case 'Tab':
      // Only on the canvas itself: from node to node it goes as everywhere.
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

/** Folds what is selected to headers, or opens it. */
function collapse(editor: GraphEditor): boolean {
  const { nodes } = editor.graph.value;
  const chosen = [...editor.selection.value.nodes].flatMap((id) => nodes.get(id) ?? []);
  const command = collapseCommand(chosen);
  if (command !== undefined) editor.apply(command);
  return command !== undefined;
}

/** Lets the selected modules rest, or work again when all of them rest in that way. */
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
      // Taken from the browser also where there is nothing to frame.
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
