import { NodeEditor, type GetSchemes } from 'rete';
import { AreaPlugin, Drag } from 'rete-area-plugin';
import { shallowReactive, shallowRef, type ShallowRef } from 'vue';
import type { Point, PortRef, Size } from '../model/graph.ts';
import { bounds, type Box as NodeBox } from '../model/selection/arrange.ts';
import { FrameQueue } from './frame-queue.ts';
import { PanLayer } from './pan-layer.ts';
import { detailAt, overlaps, seenArea, type Detail } from './seen-area.ts';
import {
  insideNode,
  limitZoom,
  MAX_ZOOM,
  MIN_ZOOM,
  NO_COVER,
  clearViewOf,
  type Box,
  type Cover,
  type View,
} from './stage-view.ts';

type Schemes = GetSchemes<{ id: string }, { id: string; source: string; target: string }>;

/** Time without movement after which the canvas counts as at rest, milliseconds. */
const REST_MS = 200;
const NO_SIZE: Size = { width: 0, height: 0 };

/** Key of a port in maps. */
export const portKey = ({ node, port }: PortRef): string => `${node} ${port}`;

/**
 * Canvas: Rete positions nodes, pans and zooms; the caller decides which nodes exist, with `show`. Node views are
 * rendered into `elements`, wires and chips into layers that move along.
 */
export class CanvasStage {
  /** Host element of each node's view, by node id. */
  readonly elements = shallowReactive(new Map<string, HTMLElement>());
  /** Current positions of nodes, also while they are dragged. */
  readonly positions = shallowReactive(new Map<string, Point>());
  readonly sizes = shallowReactive(new Map<string, Size>());
  /** Centres of sockets relative to the top left of their node, by `portKey`. */
  readonly sockets = shallowReactive(new Map<string, Point>());
  readonly view: ShallowRef<View> = shallowRef({ x: 0, y: 0, k: 1 });
  /** Size of the canvas on the page, pixels. */
  readonly viewport: ShallowRef<Size> = shallowRef({ width: 0, height: 0 });
  /** Drawn area. Changes rarely; `view` changes in every frame of a pan. */
  readonly area: ShallowRef<Box> = shallowRef({ x: 0, y: 0, width: 0, height: 0 });
  readonly detail: ShallowRef<Detail> = shallowRef('near');
  /** True while the canvas is panned or zoomed or nodes are dragged; other drawing can wait. */
  readonly isMoving: ShallowRef<boolean> = shallowRef(false);
  /** Layer below all others. */
  readonly ground = layer('ground');
  /** One finger draws a selection box instead of panning. */
  readonly isSelecting: ShallowRef<boolean> = shallowRef(false);
  /** Layer below the nodes. */
  readonly wires = layer('wires');
  /** Layer above the wires and below the nodes, so that no chip covers a socket. */
  readonly chips = layer('chips');
  /** Layer above the nodes. */
  readonly guides = layer('guides');
  /** Work for nodes that came close to the visible area, done in the next frames. */
  readonly soon = new FrameQueue();
  /** Returns the expected position of a socket that is not rendered yet. */
  socketLater: (ref: PortRef) => Point | undefined = () => undefined;
  readonly container: HTMLElement;
  /** While true, every pointer pans. */
  isPanning = false;

  readonly #editor = new NodeEditor<Schemes>();
  readonly #area: AreaPlugin<Schemes>;
  readonly #layer: PanLayer;
  readonly #observer = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = this.container;
    this.viewport.value = { width, height };
    this.area.value = seenArea(this.view.value, this.viewport.value, undefined);
  });
  /** One observer for all nodes: with one each, browsers do a layout of the page per node. */
  readonly #sizeObserver = new ResizeObserver((entries) => {
    for (const { target } of entries)
      this.#measureNow((target as HTMLElement).dataset['graphNode']!);
  });
  /** Covers everything while the canvas is panned: saves the browser's hit tests. */
  readonly #shield = layer('shield');
  #isHeld = false;
  readonly #toMeasure = new Set<string>();
  #movingTimer: ReturnType<typeof setTimeout> | undefined;
  /** Nodes that the user drags: they follow the pointer. */
  #held: ReadonlySet<string> = new Set();
  /** Serialises changes of the stage. */
  #queue: Promise<void> = Promise.resolve();

  constructor(container: HTMLElement) {
    this.container = container;
    this.#area = new AreaPlugin<Schemes>(container);
    this.#layer = new PanLayer(this.#area.area.content.holder);
    this.#observer.observe(container);
    this.#area.area.setDragHandler(
      new Drag({ down: (event) => this.#isPan(event) && this.#hold(), move: () => true }),
    );
    this.#area.area.content.add(this.ground);
    this.#area.area.content.add(this.wires);
    this.#area.area.content.add(this.chips);
    this.#area.area.content.add(this.guides);
    this.#editor.use(this.#area);
    this.#area.addPipe((context) => {
      const { type } = context;
      if (type === 'render') {
        if (context.data.type !== 'node') return context;
        const { payload, element } = context.data;
        // Disables Rete's own dragging; see drag/node-drag.ts.
        this.#area.nodeViews.get(payload.id)?.dragHandler.destroy();
        element.classList.add('graph-node-holder');
        this.elements.set(payload.id, element);
      } else if (type === 'zoom') {
        const { zoom, source } = context.data;
        if (source === 'dblclick' || zoom < MIN_ZOOM || zoom > MAX_ZOOM) return undefined;
      } else if (type === 'translated' || type === 'zoomed') {
        this.#look();
        if (type === 'translated') this.#layer.hold(this.view.value);
        else this.#layer.follow(this.view.value);
        if (this.#isHeld && !this.#shield.isConnected) this.container.append(this.#shield);
        this.#noteMoving();
      } else if (type === 'nodetranslated') {
        const { id, position } = context.data;
        this.#place(id, position);
        if (this.#held.has(id)) this.#noteMoving();
      }
      return context;
    });
  }

  /** Shows exactly these nodes, each at its position. */
  show(places: ReadonlyMap<string, Point>): Promise<void> {
    this.#queue = this.#queue.then(() => this.#reconcile(places));
    return this.#queue;
  }

  async #reconcile(places: ReadonlyMap<string, Point>): Promise<void> {
    for (const id of [...this.elements.keys()]) {
      if (places.has(id)) continue;
      // Unmount the view before its host element is removed.
      this.elements.delete(id);
      this.positions.delete(id);
      this.sizes.delete(id);
      await this.#editor.removeNode(id);
    }
    const added = [...places.keys()].filter((id) => !this.elements.has(id));
    await Promise.all(added.map((id) => this.#editor.addNode({ id })));
    const moved = [...places].filter(([id, { x, y }]) => {
      if (this.#held.has(id)) return false;
      const old = this.positions.get(id);
      return old?.x !== x || old.y !== y;
    });
    await Promise.all(moved.map(([id, place]) => this.#area.translate(id, { ...place })));
  }

  /** Moves nodes at once; ignores nodes that are not on the stage. */
  put(places: Iterable<readonly [id: string, place: Point]>): void {
    for (const [id, place] of places) {
      if (this.elements.has(id)) void this.#area.translate(id, { ...place });
    }
  }

  /** Keeps these nodes where `put` placed them, ignoring `show`, until the next call. */
  hold(ids: ReadonlySet<string>): void {
    this.#held = ids;
  }

  /** Converts page coordinates to canvas coordinates. */
  toCanvas(clientX: number, clientY: number): Point {
    const { left, top } = this.container.getBoundingClientRect();
    const { x, y, k } = this.view.value;
    return { x: (clientX - left - x) / k, y: (clientY - top - y) / k };
  }

  /** Centre of the visible part, in canvas coordinates. */
  get middle(): Point {
    const { left, top, width, height } = this.container.getBoundingClientRect();
    return this.toCanvas(left + width / 2, top + height / 2);
  }

  /** Position of a socket, expected if it is not rendered yet; the edge of the node if it has none. */
  socketAt(ref: PortRef, side: 'in' | 'out'): Point | undefined {
    const position = this.positions.get(ref.node);
    if (position === undefined) return undefined;
    const offset = this.sockets.get(portKey(ref)) ?? this.socketLater(ref);
    const size = this.#sizeOf(ref.node);
    const at = insideNode(offset ?? { x: side === 'in' ? 0 : size.width, y: 15 }, size);
    return { x: position.x + at.x, y: position.y + at.y };
  }

  /**
   * Measures the sockets of a node after all pending changes: measuring each node while others are being created causes
   * one layout of the page per node.
   */
  measure(id: string): void {
    if (this.#toMeasure.size === 0) {
      queueMicrotask(() => {
        const ids = [...this.#toMeasure];
        this.#toMeasure.clear();
        for (const each of ids) this.#measureNow(each);
      });
    }
    this.#toMeasure.add(id);
  }

  /** Measures the view of a node now and whenever its size changes. Returns a function that stops it. */
  watchSize(view: Element): () => void {
    this.#sizeObserver.observe(view);
    return () => this.#sizeObserver.unobserve(view);
  }

  #measureNow(id: string): void {
    const holder = this.elements.get(id);
    if (holder === undefined || holder.offsetWidth === 0) return;
    const { k } = this.view.value;
    const origin = holder.getBoundingClientRect();
    const size = { width: holder.offsetWidth, height: holder.offsetHeight };
    const before = this.sizes.get(id);
    if (before?.width !== size.width || before.height !== size.height) this.sizes.set(id, size);
    for (const socket of holder.querySelectorAll<HTMLElement>('[data-port]')) {
      const box = socket.getBoundingClientRect();
      const point = {
        x: Math.round(((box.left + box.width / 2 - origin.left) / k) * 2) / 2,
        y: Math.round(((box.top + box.height / 2 - origin.top) / k) * 2) / 2,
      };
      const key = portKey({ node: id, port: socket.dataset['port'] ?? '' });
      const old = this.sockets.get(key);
      if (old?.x !== point.x || old.y !== point.y) this.sockets.set(key, point);
    }
  }

  /** Visible part of the canvas. */
  get seen(): Box {
    const { x, y, k } = this.view.value;
    const { width, height } = this.viewport.value;
    return { x: -x / k, y: -y / k, width: width / k, height: height / k };
  }

  /** True when a part of the node is visible. */
  isInView(id: string): boolean {
    const position = this.positions.get(id);
    return position !== undefined && overlaps({ ...position, ...this.#sizeOf(id) }, this.seen);
  }

  /** Current boxes of nodes. */
  boxes(ids: Iterable<string> = this.positions.keys()): NodeBox[] {
    return [...ids].flatMap((id) => {
      const position = this.positions.get(id);
      return position === undefined ? [] : [{ id, ...position, ...this.#sizeOf(id) }];
    });
  }

  /** Bounding box of these nodes; default: of all. */
  boxOf(ids?: Iterable<string>): Box | undefined {
    const boxes = this.boxes(ids);
    return boxes.length === 0 ? undefined : bounds(boxes);
  }

  /** Fits all nodes, or these, into the view. */
  fit(ids?: Iterable<string>, cover?: Cover): Promise<void> {
    return this.fitBoxes(this.boxes(ids), cover);
  }

  /** Fits boxes of the canvas into the view. */
  async fitBoxes(boxes: readonly Box[], cover: Cover = NO_COVER): Promise<void> {
    const { clientWidth: width, clientHeight: height } = this.container;
    if (boxes.length === 0 || width === 0) return;
    // The ResizeObserver reports only after the first frame.
    if (this.viewport.value.width === 0) this.viewport.value = { width, height };
    const { x, y, k } = clearViewOf(boxes, { width, height }, cover);
    await this.#area.area.zoom(k);
    await this.#area.area.translate(x, y);
  }

  /** Zooms around the centre of the view. */
  async zoomTo(k: number): Promise<void> {
    const wanted = limitZoom(k);
    const { clientWidth, clientHeight } = this.container;
    const { x, y, k: old } = this.view.value;
    const factor = 1 - wanted / old;
    await this.#area.area.zoom(
      wanted,
      (clientWidth / 2 - x) * factor,
      (clientHeight / 2 - y) * factor,
    );
  }

  /** Centres the view on a point of the canvas. */
  async centre({ x, y }: Point): Promise<void> {
    const { clientWidth, clientHeight } = this.container;
    const { k } = this.view.value;
    await this.#area.area.translate(clientWidth / 2 - x * k, clientHeight / 2 - y * k);
  }

  /** Sets position and zoom at once, as pinching does. */
  async look({ x, y, k }: View): Promise<void> {
    await this.#area.area.zoom(limitZoom(k));
    await this.#area.area.translate(x, y);
  }

  /** Ends the drag of a pointer by a synthetic `pointercancel`, which Rete needs, too, to stop panning. */
  letGo(pointerId: number): void {
    window.dispatchEvent(new PointerEvent('pointercancel', { pointerId }));
  }

  /** Pans by pixels. */
  async pan(by: Point): Promise<void> {
    const { x, y } = this.view.value;
    await this.#area.area.translate(x + by.x, y + by.y);
  }

  destroy(): void {
    this.#layer.release();
    this.soon.clear();
    clearTimeout(this.#movingTimer);
    this.#observer.disconnect();
    this.#sizeObserver.disconnect();
    this.#area.destroy();
  }

  #sizeOf(id: string): Size {
    return this.sizes.get(id) ?? NO_SIZE;
  }

  #look(): void {
    const view = { ...this.#area.area.transform };
    this.view.value = view;
    this.area.value = seenArea(view, this.viewport.value, this.area.value);
    this.detail.value = detailAt(view.k);
  }

  /** Starts panning until the pointer is released. */
  #hold(): boolean {
    const release = (): void => {
      this.#isHeld = false;
      this.#shield.remove();
      window.removeEventListener('pointerup', release, true);
      window.removeEventListener('pointercancel', release, true);
    };
    this.#isHeld = true;
    window.addEventListener('pointerup', release, true);
    window.addEventListener('pointercancel', release, true);
    return true;
  }

  #noteMoving(): void {
    this.isMoving.value = true;
    clearTimeout(this.#movingTimer);
    this.#movingTimer = setTimeout(() => (this.isMoving.value = false), REST_MS);
  }

  /** Positioned without the transform that Rete sets: with one per node, browsers paint hundreds of layers. */
  #place(id: string, { x, y }: Point): void {
    const holder = this.elements.get(id);
    if (holder === undefined) return;
    holder.style.left = `${x}px`;
    holder.style.top = `${y}px`;
    this.positions.set(id, { x, y });
  }

  /** The middle button pans everywhere, other buttons on empty canvas; Shift draws a selection box. */
  #isPan({ pointerType, button, shiftKey, target }: PointerEvent): boolean {
    if (this.isPanning || (pointerType === 'mouse' && button === 1)) return true;
    if (shiftKey || button !== 0) return false;
    if (this.isSelecting.value && pointerType !== 'mouse') return false;
    return !(target as Element).closest('[data-graph-node]');
  }
}

function layer(name: string): HTMLElement {
  const element = document.createElement('div');
  element.className = `graph-layer graph-${name}`;
  return element;
}
