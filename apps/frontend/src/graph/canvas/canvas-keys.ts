import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editor/graph-editor.ts';
import type { Point } from '../model/graph.ts';
import { duplicate } from '../model/selection/clipboard.ts';
import { removeAndReconnect } from '../model/selection/reconnect.ts';

/** What keys do besides editing the graph. */
export interface CanvasActions {
  fit(): void;
  add(): void;
  find(): void;
  cancel(): void;
  open(node: string): void;
}

const STEP = 10;
const BIG_STEP = 40;
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: { x: -1, y: 0 },
  ArrowRight: { x: 1, y: 0 },
  ArrowUp: { x: 0, y: -1 },
  ArrowDown: { x: 0, y: 1 },
};

/** Does what a key asks for. @returns true when it was one of ours */
export function canvasKey(
  editor: GraphEditor,
  event: KeyboardEvent,
  actions: CanvasActions,
): boolean {
  const { nodes, wire } = editor.selection.value;
  if (event.ctrlKey || event.metaKey) return commandKey(editor, event, actions);
  if (event.altKey) return false;
  const arrow = ARROWS[event.key];
  if (arrow !== undefined) {
    if (nodes.size === 0) return false;
    const step = event.shiftKey ? BIG_STEP : STEP;
    const places = editor.places.value;
    const moved = [...nodes].map((id) => {
      const { x, y } = places.get(id) ?? { x: 0, y: 0 };
      return [id, { x: x + arrow.x * step, y: y + arrow.y * step }] as const;
    });
    editor.apply({ kind: 'move', positions: new Map(moved) }, 'arrows');
    return true;
  }
  switch (event.key) {
    case 'Delete':
    case 'Backspace':
      if (wire !== undefined) editor.apply({ kind: 'remove', wires: [wire] });
      // With Shift, what fed the nodes feeds what they fed.
      else if (nodes.size > 0 && event.shiftKey)
        editor.apply(removeAndReconnect(editor.graph.value, [...nodes]));
      else if (nodes.size > 0) editor.apply({ kind: 'remove', nodes: [...nodes] });
      else return false;
      return true;
    case 'Escape':
      actions.cancel();
      return true;
    case 'Enter': {
      const [only] = nodes;
      if (only === undefined) return false;
      actions.open(only);
      return true;
    }
    case 'b':
      return toggleStanding(editor, 'bypassed');
    case 'm':
      return toggleStanding(editor, 'muted');
    case 'f':
    case 'F':
      actions.fit();
      return true;
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
  editor: GraphEditor,
  { key, shiftKey }: KeyboardEvent,
  actions: CanvasActions,
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
