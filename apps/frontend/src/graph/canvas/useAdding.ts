import { shallowRef, watch, type Ref, type ShallowRef } from 'vue';
import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import type { Adapter } from '../model/fit/adapter.ts';
import { adaptCommand } from '../model/fit/adapt.ts';
import { offerCommand } from '../model/fit/fitting.ts';
import type { Point, PortRef, Size } from '../model/graph.ts';
import { portOf } from '../model/port-format.ts';
import { frameUnder } from '../model/selection/frames.ts';
import { insertOnWire } from '../model/selection/insert.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import type { Addable } from './addable.ts';
import type { CanvasStage } from './canvas-stage.ts';
import type { ConnectGesture, Offer } from './connect-gesture.ts';
import { drawnSize } from '../nodes/drawn-size.ts';
import { freeSpot, NODE_HALF, onGrid } from './free-spot.ts';
import { inHost } from './in-host.ts';
import { insertedText, misfitOnWire } from './insert-words.ts';
import { keepPlaces } from './keep-places.ts';
import type { KeyWalk } from './keys/key-walk.ts';
import { newNode, type NewNode } from './new-nodes.ts';
import type { Box } from './stage-view.ts';
import { viewShowing } from './view-showing.ts';
import { roomiest } from './wire-hit.ts';

/** Position and purpose of the palette that adds nodes by name. */
export interface AddingSpot {
  /** Position of the new node on the canvas. */
  readonly at: Point;
  readonly left: number;
  readonly top: number;
  /** End of a wire that was dropped there. */
  readonly end: Pick<Offer, 'from' | 'side'> | undefined;
  /** Id of the wire that was selected; a fitting node is inserted into it. */
  readonly wire: string | undefined;
  /** Opened to insert into the wire: only fitting nodes are offered. */
  readonly isInto?: boolean;
  /** Opened without a position: use a free one in view. */
  readonly isAnywhere?: boolean;
  /** Existing sockets that fit are offered, too. */
  readonly hasSockets?: boolean;
}

/** Request of a menu to add a node at a position: at a socket, into a wire, or unconnected. */
export interface AddingWish {
  readonly at: Point;
  readonly end: PortRef | undefined;
  readonly wire: string | undefined;
}

export interface Adding {
  readonly spot: Readonly<ShallowRef<AddingSpot | undefined>>;
  /** @param clientX on the page, pixels */
  askAt(clientX: number, clientY: number, end?: AddingSpot['end']): void;
  askInMiddle(): void;
  askFor(wish: AddingWish): void;
  /** Opens the list of ends for a wire from a socket: existing fitting sockets, or new nodes. */
  askToConnect(from: PortRef): void;
  choose(chosen: Addable): void;
  /** @param isDismissed the focus returns to the canvas; otherwise it is elsewhere already */
  close(isDismissed: boolean): void;
  /** Adds a node to the canvas. */
  place(item: NewNode, at: Point): void;
  placeInMiddle(item: NewNode): void;
  /** Inserts an adapter that makes a refused wire fit. */
  takeOffer(adapter: Adapter): void;
}

/** Widths at the edges of the canvas that docks cover, pixels. */
const COVERED = { left: 24, top: 60, right: 24, bottom: 72 };
/** Horizontal distance of a new node from the socket it is wired to, canvas units. */
const FROM_SOCKET = 90;
/** Up to this number of nodes, all are fitted into view when a new one is off the screen. */
const FEW = 8;
const MENU = { width: 330, height: 320 };

/** Adds nodes: by name, by dropping a wire on empty canvas, and as adapters between ports that do not fit. */
export function useAdding(
  host: Ref<HTMLElement | null>,
  editor: GraphEditor,
  stage: CanvasStage,
  gesture: ConnectGesture,
  walk: KeyWalk,
  showAll: () => Promise<void>,
  tell: (sentence: string) => void,
): Adding {
  const spot = shallowRef<AddingSpot>();

  function askAt(clientX: number, clientY: number, end?: AddingSpot['end']): void {
    const at = stage.toCanvas(clientX, clientY);
    const { wire } = editor.selection.value;
    spot.value = { at, ...inHost(stage.container, clientX, clientY, MENU), end, wire };
  }
  /** Visible part of the canvas that no dock covers. */
  function clearArea(): Box {
    const { x, y, width, height } = stage.seen;
    const { k } = stage.view.value;
    return {
      x: x + COVERED.left / k,
      y: y + COVERED.top / k,
      width: width - (COVERED.left + COVERED.right) / k,
      height: height - (COVERED.top + COVERED.bottom) / k,
    };
  }
  watch(gesture.offer, (offer) => {
    if (offer === undefined) return;
    askAt(offer.clientX, offer.clientY, { from: offer.from, side: offer.side });
  });

  function place(item: NewNode, at: Point): void {
    const node = newNode(item, onGrid(at), randomUuid);
    if (editor.graph.value.nodes.has(node.id)) {
      // A topic has one node per canvas: show the existing one.
      void stage.fit([node.id]);
    } else {
      const { nodes } = editor.graph.value;
      const frames = stage.boxes().filter(({ id }) => nodes.get(id)?.kind === 'frame');
      const box = { id: node.id, ...at, ...drawnSize(node) };
      const frame = frameUnder(new Map([...nodes, [node.id, node]]), box, frames);
      const step = `add ${node.id}`;
      const kept = keepPlaces(editor.graph.value, stage.positions);
      if (kept !== undefined) editor.apply(kept, step);
      editor.apply({ kind: 'add', nodes: [{ ...node, frame }] }, step);
      editor.seal();
    }
    editor.select([node.id]);
  }

  /** Inserts a node into a wire where it has most room. @returns whether it fits there */
  function placeOnWire(item: NewNode, id: string | undefined): boolean {
    const graph = editor.graph.value;
    const wire = id === undefined ? undefined : graph.wires.get(id);
    if (wire === undefined) return false;
    const [from, to] = [stage.socketAt(wire.from, 'out'), stage.socketAt(wire.to, 'in')];
    if (from === undefined || to === undefined) return false;
    const { x, y, leg } = roomiest(from, to, wire.points);
    const node = newNode(item, { x: 0, y: 0 }, randomUuid);
    const size = drawnSize(node);
    const at = onGrid({ x: x - size.width / 2, y: y - NODE_HALF.y });
    const boxes = [...stage.boxes(), { id: node.id, ...at, ...size }];
    const command = insertOnWire(graph, wire.id, { ...node, position: at }, leg, boxes);
    if (command === undefined) {
      tell(`${misfitOnWire(graph, wire, node)} It was added beside the wire.`);
      return false;
    }
    editor.apply(command);
    editor.select([node.id]);
    tell(insertedText(graph, wire, node, isAlive(editor.session.value)));
    return true;
  }

  /**
   * In small graphs, to the right of the selected node, in the direction of the data; otherwise the centre of the view.
   */
  function nextSpot(
    isSmall: boolean,
    { width, height }: Size,
  ): Point & { readonly isBeside: boolean } {
    const [only, ...others] = editor.selection.value.nodes;
    const isOne = isSmall && only !== undefined && others.length === 0;
    const [box] = isOne ? stage.boxes([only]) : [];
    if (box !== undefined) return { x: box.x + box.width + FROM_SOCKET, y: box.y, isBeside: true };
    const { x, y } = stage.middle;
    return { x: x - width / 2, y: y - height / 2, isBeside: false };
  }
  function placeInMiddle(item: NewNode): void {
    const isSmall = editor.graph.value.nodes.size < FEW;
    const before = editor.graph.value.nodes;
    const size = drawnSize(newNode(item, { x: 0, y: 0 }, randomUuid));
    const { isBeside, ...wish } = nextSpot(isSmall, size);
    const area = isBeside ? {} : { area: clearArea() };
    place(item, freeSpot(stage, editor.graph.value, wish, { size, ...area }));
    const added = [...editor.graph.value.nodes.values()].find(({ id }) => !before.has(id));
    if (!isSmall || added?.position === undefined) return;
    const box = { ...added.position, ...drawnSize(added) };
    if (viewShowing(stage.view.value, stage.viewport.value, box) !== undefined) void showAll();
  }

  return {
    spot,
    askFor({ at: { x, y }, end: from, wire }) {
      const view = stage.view.value;
      const { left, top } = stage.container.getBoundingClientRect();
      const side = from && portOf(editor.graph.value, from)?.direction;
      const end = from && side && { from, side };
      const gap = side === undefined ? 0 : side === 'out' ? FROM_SOCKET : -FROM_SOCKET;
      const [clientX, clientY] = [x * view.k + view.x + left, y * view.k + view.y + top];
      const place = inHost(stage.container, clientX, clientY, MENU);
      spot.value = { at: { x: x + gap, y }, ...place, end, wire, isInto: wire !== undefined };
    },
    askToConnect(from) {
      const side = portOf(editor.graph.value, from)?.direction;
      const at = side && stage.socketAt(from, side);
      if (side === undefined || at === undefined) return;
      const { x, y, k } = stage.view.value;
      const { left, top } = stage.container.getBoundingClientRect();
      const [clientX, clientY] = [at.x * k + x + left + 16, at.y * k + y + top + 12];
      const place = inHost(stage.container, clientX, clientY, MENU);
      const gap = side === 'out' ? FROM_SOCKET : -FROM_SOCKET;
      const spotAt = { x: at.x + gap, y: at.y };
      spot.value = { at: spotAt, ...place, end: { from, side }, wire: undefined, hasSockets: true };
    },
    askAt,
    askInMiddle() {
      const { left, top, width, height } = stage.container.getBoundingClientRect();
      askAt(left + width / 2 - MENU.width / 2, top + height / 3);
      spot.value = { ...spot.value!, isAnywhere: true };
    },
    choose({ item, offer, port }) {
      const chosen = spot.value;
      spot.value = undefined;
      host.value?.focus();
      if (chosen === undefined) return;
      const { at, end, wire, isAnywhere } = chosen;
      if (port !== undefined && end !== undefined) {
        const { left, top } = stage.container.getBoundingClientRect();
        gesture.connect(end.from, port, {
          clientX: left + chosen.left,
          clientY: top + chosen.top,
        });
        void walk.focusSocket(end.from);
        return;
      }
      if (item !== undefined && !placeOnWire(item, end === undefined ? wire : undefined)) {
        if (isAnywhere === true) placeInMiddle(item);
        else place(item, at);
      }
      if (item !== undefined) {
        // Focus the new node, or the existing one.
        const [selected] = editor.selection.value.nodes;
        if (selected !== undefined) void walk.focusNode(selected);
      }
      if (offer === undefined || end === undefined) return;
      const left = end.side === 'out' ? at.x : at.x - 2 * NODE_HALF.x;
      const wish = { x: left, y: at.y - NODE_HALF.y };
      const position = freeSpot(stage, editor.graph.value, wish);
      const options = { uuid: randomUuid, position };
      const before = editor.graph.value.nodes;
      const kept = keepPlaces(editor.graph.value, stage.positions);
      if (kept !== undefined) editor.apply(kept, 'add at socket');
      editor.apply(offerCommand(editor.graph.value, end.from, offer, options), 'add at socket');
      editor.seal();
      const added = [...editor.graph.value.nodes.values()].find(({ id }) => !before.has(id));
      if (added === undefined) return;
      editor.select([added.id]);
      if (chosen.hasSockets === true) void walk.focusSocket(end.from);
      const box = { ...position, ...drawnSize(added) };
      const view = viewShowing(stage.view.value, stage.viewport.value, box);
      if (view === undefined) return;
      if (editor.graph.value.nodes.size <= FEW) void showAll();
      else void stage.look(view);
    },
    close(isDismissed) {
      const end = spot.value?.hasSockets === true ? spot.value.end : undefined;
      spot.value = undefined;
      if (end !== undefined) void walk.focusSocket(end.from);
      else if (isDismissed) host.value?.focus({ preventScroll: true });
    },
    place,
    placeInMiddle,
    takeOffer(adapter) {
      const refusal = gesture.refusal.value;
      gesture.refusal.value = undefined;
      if (refusal === undefined) return;
      const { from, to } = refusal.fit;
      const [a, b] = [stage.socketAt(from, 'out'), stage.socketAt(to, 'in')];
      if (a === undefined || b === undefined) return;
      const middle = { x: (a.x + b.x) / 2 - NODE_HALF.x, y: (a.y + b.y) / 2 - NODE_HALF.y };
      const options = { uuid: randomUuid, position: freeSpot(stage, editor.graph.value, middle) };
      const before = editor.graph.value.nodes;
      editor.apply(adaptCommand(editor.graph.value, from, to, adapter, options));
      editor.select([...editor.graph.value.nodes.keys()].filter((id) => !before.has(id)));
    },
  };
}
