import type { Ref } from 'vue';
import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editor/graph-editor.ts';
import type { Point, PortRef } from '../model/graph.ts';
import { insertOnWire } from '../model/selection/insert.ts';
import type { DraggedItem } from '../palette/drag-item.ts';
import type { CanvasStage } from './canvas-stage.ts';
import { socketUnder, type ConnectGesture } from './connect-gesture.ts';
import { freeSpot, NODE_HALF, onGrid } from './free-spot.ts';
import { newNode, type NewNode } from './new-nodes.ts';

/** What dropping works on. */
export interface DropTarget {
  readonly host: Ref<HTMLElement | null>;
  readonly editor: GraphEditor;
  readonly stage: CanvasStage;
  readonly gesture: ConnectGesture;
  /** Puts it on the canvas by itself. */
  place(item: NewNode, at: Point): void;
}

type TopicItem = Extract<NewNode, { kind: 'topic' }>;

/** A topic stands this far from the socket it is wired to. */
const BEFORE = -280;
const BEHIND = 110;

/** What was dragged from the palette lands on a socket, on a wire or on the canvas. */
export function useDrop(target: DropTarget): (dragged: DraggedItem) => void {
  const { host, editor, stage, gesture, place } = target;

  return ({ item, clientX, clientY }) => {
    const under = document.elementFromPoint(clientX, clientY);
    if (!host.value?.contains(under)) return;
    const pointer = stage.toCanvas(clientX, clientY);
    const at = { x: pointer.x - NODE_HALF.x, y: pointer.y - NODE_HALF.y / 2 };
    const wire = under?.closest<HTMLElement>('[data-wire]')?.dataset['wire'];
    if (wire !== undefined && insert(item, wire, at)) return;
    const port = socketUnder({ clientX, clientY });
    const node = port && editor.graph.value.nodes.get(port.node);
    if (port !== undefined && node?.kind === 'module' && item.kind === 'topic') {
      mapTopic(item, port, { clientX, clientY });
    } else {
      place(item, at);
    }
  };

  function insert(item: NewNode, wire: string, at: Point): boolean {
    if (item.kind !== 'module') return false;
    const node = newNode(item, onGrid(at), randomUuid);
    const command = insertOnWire(editor.graph.value, wire, node);
    if (command === undefined) return false;
    editor.apply(command);
    editor.select([node.id]);
    return true;
  }

  function mapTopic(
    item: TopicItem,
    port: PortRef,
    at: { clientX: number; clientY: number },
  ): void {
    const graph = editor.graph.value;
    const isInput = port.port.startsWith('in:');
    const socket =
      stage.socketAt(port, isInput ? 'in' : 'out') ?? stage.toCanvas(at.clientX, at.clientY);
    const beside = { x: socket.x + (isInput ? BEFORE : BEHIND), y: socket.y - NODE_HALF.y };
    const node = newNode(item, freeSpot(stage, graph, beside), randomUuid);
    const own = { node: node.id, port: isInput ? 'out' : 'in' };
    const step = 'drop topic';
    if (!graph.nodes.has(node.id)) editor.apply({ kind: 'add', nodes: [node] }, step);
    if (gesture.connect(own, port, at, step)) editor.select([port.node]);
    editor.seal();
  }
}
