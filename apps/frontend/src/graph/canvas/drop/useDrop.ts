import { watch, type Ref } from 'vue';
import { randomUuid } from '../../../connection/random-uuid.ts';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { Point, PortRef } from '../../model/graph.ts';
import type { InsertPlace } from '../../model/selection/drop-nodes.ts';
import { insertOnWire } from '../../model/selection/insert.ts';
import { isAlive } from '../../../sessions/state/session-state.ts';
import { canRun } from '../../../sessions/words/node-words.ts';
import { draggedItem, type DraggedItem, type HostItem } from './drag-item.ts';
import { placeCommand } from '../../model/commands/place-command.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { socketUnder, type ConnectGesture } from '../connect-gesture.ts';
import { spotsOnStage, type InsertTarget } from '../drag/insert-target.ts';
import { drawnSize } from '../../nodes/drawn-size.ts';
import { freeSpot, NODE_HALF, onGrid } from '../free-spot.ts';
import { insertedText, misfitOnWire } from '../insert-words.ts';
import { keepPlaces } from '../keep-places.ts';
import { newNode, type NewNode } from '../new-nodes.ts';
import { nearestOn } from '../wire-hit.ts';

/** State and commands that dropping uses. */
export interface DropTarget {
  readonly host: Ref<HTMLElement | null>;
  readonly editor: GraphEditor;
  readonly stage: CanvasStage;
  readonly gesture: ConnectGesture;
  readonly target: InsertTarget;
  /** Announces in one line why a drop had no effect. */
  tell(sentence: string): void;
  /** Adds a node at a position. */
  place(item: NewNode, at: Point): void;
}

type TopicItem = Extract<NewNode, { kind: 'topic' }>;

/** Horizontal distance of a topic from the socket it is wired to, canvas units. */
const BEFORE = -280;
const BEHIND = 110;
/** Smallest distance of a topic from the module, and size of the area searched for a free position, canvas units. */
const APART = 40;
const AROUND = 1600;

/** Returns the handler for items dropped from the palette on a socket, a wire or the canvas. */
export function useDrop(on: DropTarget): (dragged: DraggedItem) => void {
  const { host, editor, stage, gesture, target: wires, place, tell } = on;
  useWireUnder(on);

  return ({ item, clientX, clientY }) => {
    const spot = wires.end();
    const under = document.elementFromPoint(clientX, clientY);
    if (!host.value?.contains(under)) return;
    // Focus the canvas so that its keys apply to the new node.
    host.value.focus();
    if (item.kind === 'host') {
      runOn(item, under);
      return;
    }
    const pointer = stage.toCanvas(clientX, clientY);
    const at = { x: pointer.x - NODE_HALF.x, y: pointer.y - NODE_HALF.y / 2 };
    if (spot !== undefined && insert(item, spot, at)) return;
    const port =
      socketUnder({ clientX, clientY }) ??
      gesture.nearestSocket({ clientX, clientY }) ??
      (item.kind === 'topic' ? rowUnder(under) : undefined);
    const node = port && editor.graph.value.nodes.get(port.node);
    if (port !== undefined && node?.kind === 'module' && item.kind === 'topic') {
      mapTopic(item, port, { clientX, clientY });
    } else {
      if (port === undefined) tellMisfit(item, pointer);
      place(item, at);
    }
  };

  /** Port in whose row a topic was dropped: the whole row counts, not only its socket. */
  function rowUnder(under: Element | null): PortRef | undefined {
    const { node, rowPort } = under?.closest<HTMLElement>('[data-row-port]')?.dataset ?? {};
    return node === undefined || rowPort === undefined ? undefined : { node, port: rowPort };
  }

  function runOn({ host: runner }: HostItem, under: Element | null): void {
    const id = under?.closest<HTMLElement>('[data-graph-node]')?.dataset['graphNode'];
    const node = id === undefined ? undefined : editor.graph.value.nodes.get(id);
    if (node?.kind !== 'module') {
      tell('Drop this node on a module to run the module there.');
    } else if (!canRun(runner, node.module)) {
      tell(`${runner.name || 'This node'} cannot run ${node.module.name}.`);
    } else {
      editor.apply(placeCommand(node, runner.clientId));
      editor.select([node.id]);
    }
  }

  function insert(item: NewNode, { wire: id, leg }: InsertPlace, at: Point): boolean {
    const graph = editor.graph.value;
    const node = newNode(item, onGrid(at), randomUuid);
    const boxes = [...stage.boxes(), { id: node.id, ...onGrid(at), ...drawnSize(node) }];
    const wire = graph.wires.get(id);
    const command = insertOnWire(graph, id, node, leg, boxes);
    if (wire === undefined || command === undefined) return false;
    editor.apply(command);
    editor.select([node.id]);
    tell(insertedText(graph, wire, node, isAlive(editor.session.value)));
    return true;
  }

  /** Announces why a module dropped on a wire was not inserted. */
  function tellMisfit(item: NewNode, pointer: Point): void {
    if (item.kind !== 'module') return;
    const graph = editor.graph.value;
    const reach = WIRE_PX / stage.view.value.k;
    const under = [...graph.wires.values()].find((wire) => {
      const near = nearestOn(spotsOnStage(stage, wire), pointer);
      return near !== undefined && near.distance <= reach;
    });
    if (under === undefined) return;
    const node = newNode(item, pointer, randomUuid);
    tell(`${misfitOnWire(graph, under, node)} It was added beside the wire.`);
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
    const size = drawnSize(newNode(item, socket, randomUuid));
    const beside = { x: socket.x + (isInput ? BEFORE : BEHIND), y: socket.y - size.height / 2 };
    // Data flows to the right: above or below the module, the wire would lead back.
    const area = {
      x: isInput ? socket.x - AROUND : socket.x + APART,
      y: socket.y - AROUND / 2,
      width: AROUND - APART,
      height: AROUND,
    };
    const node = newNode(item, freeSpot(stage, graph, beside, { size, area }), randomUuid);
    const own = { node: node.id, port: isInput ? 'out' : 'in' };
    const step = 'drop topic';
    const kept = keepPlaces(graph, stage.positions);
    if (kept !== undefined) editor.apply(kept, step);
    if (!graph.nodes.has(node.id)) editor.apply({ kind: 'add', nodes: [node] }, step);
    gesture.connect(own, port, at, step);
    editor.select([editor.graph.value.nodes.has(node.id) ? node.id : port.node]);
    editor.seal();
  }
}

/** Largest distance from a wire at which a dragged item is inserted into it, pixels. */
const WIRE_PX = 22;

/** Highlights the wire that an item dragged from the palette would be inserted into. */
function useWireUnder({ host, editor, stage, target }: DropTarget): void {
  let item: NewNode | undefined;
  watch(draggedItem, (dragged) => {
    if (dragged?.item.kind === 'host') return;
    if (dragged === undefined) {
      if (item !== undefined) target.end();
      item = undefined;
      return;
    }
    if (dragged.item !== item) {
      item = dragged.item;
      target.begin(editor.graph.value, newNode(item, { x: 0, y: 0 }, randomUuid));
    }
    const { clientX, clientY } = dragged;
    const isOver = host.value?.contains(document.elementFromPoint(clientX, clientY)) === true;
    const hasPort = socketUnder({ clientX, clientY }) !== undefined;
    const reach = isOver && !hasPort ? WIRE_PX / stage.view.value.k : -1;
    target.over(stage.toCanvas(clientX, clientY), reach);
  });
}
