import type { GraphEditor } from '../editing/graph-editor.ts';
import type { Wire } from '../model/graph.ts';
import { wiresOf } from '../model/wires-of.ts';
import type { CanvasStage } from './canvas-stage.ts';
import type { KeyWalk } from './keys/key-walk.ts';

/**
 * Selects the next or previous wire of the selected node, or of the source node of the selected wire. Order: top to
 * bottom, incoming wires first.
 */
export function walkWires(editor: GraphEditor, stage: CanvasStage, step: 1 | -1): boolean {
  const { nodes, wire: id } = editor.selection.value;
  const graph = editor.graph.value;
  const selected = id === undefined ? undefined : graph.wires.get(id);
  const [only] = nodes;
  const node = selected === undefined ? only : (walked.get(editor) ?? selected.from.node);
  if (node === undefined) return false;
  const { in: incoming, out } = wiresOf(graph, node);
  const height = (wire: Wire, side: 'in' | 'out'): number =>
    stage.socketAt(side === 'in' ? wire.to : wire.from, side)?.y ?? 0;
  const wires = [
    ...incoming.toSorted((a, b) => height(a, 'in') - height(b, 'in')),
    ...out.toSorted((a, b) => height(a, 'out') - height(b, 'out')),
  ];
  if (wires.length === 0) return false;
  const at = wires.findIndex((wire) => wire.id === id);
  if (at < 0 && selected !== undefined) {
    // The selected wire was reached from a node that it does not belong to.
    walked.delete(editor);
    return walkWires(editor, stage, step);
  }
  const next =
    at < 0 ? (step > 0 ? 0 : wires.length - 1) : (at + step + wires.length) % wires.length;
  walked.set(editor, node);
  editor.selectWire(wires[next]!.id);
  return true;
}

/** Node whose wires are being traversed, by editor. */
const walked = new WeakMap<GraphEditor, string>();

/** Moves the focus from a wire to the node at one of its ends. */
export function goToEnd(
  editor: GraphEditor,
  walk: KeyWalk,
  id: string,
  end: 'from' | 'to',
): boolean {
  const node = editor.graph.value.wires.get(id)?.[end].node;
  if (node === undefined) return false;
  editor.select([node]);
  void walk.focusNode(node);
  return true;
}
