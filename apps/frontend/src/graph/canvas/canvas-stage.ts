import { NodeEditor, type GetSchemes } from 'rete';
import { AreaPlugin, Drag } from 'rete-area-plugin';
import { shallowReactive, shallowRef, type ShallowRef } from 'vue';
import type { Point, PortRef, Size } from '../model/graph.ts';

type Schemes = GetSchemes<{ id: string }, { id: string; source: string; target: string }>;

/** Where the canvas is looked at: the place of its origin in pixels, and the zoom. */
export interface View extends Point {
  readonly k: number;
}

/** A box on the canvas. */
export interface Box extends Point, Size {}

/** What people do on the stage. */
export interface StageHandlers {
  /** A pointer went down on a node. */
  picked(id: string): void;
  /** Nodes that go along when this one is dragged. */
  companions(id: string): Iterable<string>;
  /** Nodes were dragged to new places. */
  moved(places: ReadonlyMap<string, Point>): void;
}

const GRID = 10;
const MIN_ZOOM = 0.1;
const MAX_ZOOM = 2.5;
const FIT_MARGIN = 56;
/** Fitting does not blow up small graphs. */
const MAX_FIT_ZOOM = 1;
/** How long a pan rests before it has ended, milliseconds. */
const LAYER_MS = 200;
const NO_SIZE: Size = { width: 0, height: 0 };

const snap = (value: number): number => Math.round(value / GRID) * GRID;

/** Key of a port in maps. */
export const portKey = ({ node, port }: PortRef): string => `${node} ${port}`;

/**
 * The canvas: Rete draws nodes, pans and zooms; what is on it is decided elsewhere and handed to
 * `show`. Views are rendered into `elements`, wires and chips into layers that move along.
 */
export class CanvasStage {
  /** One element for each node, to render its view into. */
  readonly elements = shallowReactive(new Map<string, HTMLElement>());
  /** Where nodes stand now, also while they are dragged. */
  readonly positions = shallowReactive(new Map<string, Point>());
  readonly sizes = shallowReactive(new Map<string, Size>());
  /** Middles of sockets, seen from the top left of their node, by `portKey`. */
  readonly sockets = shallowReactive(new Map<string, Point>());
  readonly view: ShallowRef<View> = shallowRef({ x: 0, y: 0, k: 1 });
  /** How large it is on the page, pixels. */
  readonly viewport: ShallowRef<Size> = shallowRef({ width: 0, height: 0 });
  /** Under the nodes. */
  readonly wires = layer('wires');
  /** Over the nodes. */
  readonly chips = layer('chips');
  readonly container: HTMLElement;

  readonly #editor = new NodeEditor<Schemes>();
  readonly #area: AreaPlugin<Schemes>;
  readonly #handlers: StageHandlers;
  readonly #observer = new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = this.container;
    this.viewport.value = { width, height };
  });
  #layerTimer: ReturnType<typeof setTimeout> | undefined;
  #dragged: string | undefined;
  #start: ReadonlyMap<string, Point> = new Map();
  /** One change of the stage after the other. */
  #queue: Promise<void> = Promise.resolve();

  constructor(container: HTMLElement, handlers: StageHandlers) {
    this.container = container;
    this.#handlers = handlers;
    this.#area = new AreaPlugin<Schemes>(container);
    this.#observer.observe(container);
    this.#area.area.setDragHandler(
      new Drag({
        // Shift draws a box; the middle button pans everywhere.
        down: (event) =>
          !event.shiftKey &&
          (event.pointerType !== 'mouse' || event.button === 0 || event.button === 1),
        move: () => true,
      }),
    );
    this.#area.area.content.add(this.wires);
    this.#area.area.content.add(this.chips);
    this.#editor.use(this.#area);
    this.#area.addPipe((context) => {
      const { type } = context;
      if (type === 'render') {
        if (context.data.type !== 'node') return context;
        context.data.element.classList.add('graph-node-holder');
        this.elements.set(context.data.payload.id, context.data.element);
      } else if (type === 'zoom') {
        const { zoom, source } = context.data;
        if (source === 'dblclick' || zoom < MIN_ZOOM || zoom > MAX_ZOOM) return undefined;
      } else if (type === 'translated' || type === 'zoomed') {
        this.view.value = { ...this.#area.area.transform };
        if (type === 'translated') this.#keepLayer();
      } else if (type === 'nodepicked') {
        this.#pick(context.data.id);
      } else if (type === 'nodetranslate' && context.data.id === this.#dragged) {
        const { x, y } = context.data.position;
        const position = { x: snap(x), y: snap(y) };
        return { ...context, data: { ...context.data, position } };
      } else if (type === 'nodetranslated') {
        const { id, position } = context.data;
        this.positions.set(id, position);
        if (id === this.#dragged) this.#takeAlong(position);
      } else if (type === 'nodedragged') {
        this.#drop();
      }
      return context;
    });
  }

  /** Makes these the nodes on the stage, each at its place. */
  show(places: ReadonlyMap<string, Point>): Promise<void> {
    this.#queue = this.#queue.then(() => this.#reconcile(places));
    return this.#queue;
  }

  async #reconcile(places: ReadonlyMap<string, Point>): Promise<void> {
    for (const id of [...this.elements.keys()]) {
      if (places.has(id)) continue;
      // The view goes before its element does.
      this.elements.delete(id);
      this.positions.delete(id);
      this.sizes.delete(id);
      await this.#editor.removeNode(id);
    }
    const added = [...places.keys()].filter((id) => !this.elements.has(id));
    await Promise.all(added.map((id) => this.#editor.addNode({ id })));
    const moved = [...places].filter(([id, { x, y }]) => {
      const old = this.positions.get(id);
      return old?.x !== x || old.y !== y;
    });
    await Promise.all(moved.map(([id, place]) => this.#area.translate(id, { ...place })));
  }

  /** A place on the page, on the canvas. */
  toCanvas(clientX: number, clientY: number): Point {
    const { left, top } = this.container.getBoundingClientRect();
    const { x, y, k } = this.view.value;
    return { x: (clientX - left - x) / k, y: (clientY - top - y) / k };
  }

  /** The middle of what is seen. */
  get middle(): Point {
    const { left, top, width, height } = this.container.getBoundingClientRect();
    return this.toCanvas(left + width / 2, top + height / 2);
  }

  /** Where a socket is; the edge of its node when the socket is not drawn. */
  socketAt(ref: PortRef, side: 'in' | 'out'): Point | undefined {
    const position = this.positions.get(ref.node);
    if (position === undefined) return undefined;
    const offset = this.sockets.get(portKey(ref));
    if (offset !== undefined) return { x: position.x + offset.x, y: position.y + offset.y };
    const { width } = this.sizes.get(ref.node) ?? NO_SIZE;
    return { x: position.x + (side === 'in' ? 0 : width), y: position.y + 15 };
  }

  /** Looks where the sockets of a node are. */
  measure(id: string): void {
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

  /** The box around nodes; around all without a list. */
  boxOf(ids: Iterable<string> = this.positions.keys()): Box | undefined {
    let left = Infinity;
    let top = Infinity;
    let right = -Infinity;
    let bottom = -Infinity;
    for (const id of ids) {
      const position = this.positions.get(id);
      if (position === undefined) continue;
      const { width, height } = this.sizes.get(id) ?? NO_SIZE;
      left = Math.min(left, position.x);
      top = Math.min(top, position.y);
      right = Math.max(right, position.x + width);
      bottom = Math.max(bottom, position.y + height);
    }
    return left === Infinity
      ? undefined
      : { x: left, y: top, width: right - left, height: bottom - top };
  }

  /** Shows all nodes, or these. @param inset pixels at the bottom that something covers */
  async fit(ids?: Iterable<string>, inset = 0): Promise<void> {
    const box = this.boxOf(ids);
    const { clientWidth, clientHeight } = this.container;
    if (box === undefined || clientWidth === 0) return;
    const width = clientWidth - 2 * FIT_MARGIN;
    const height = clientHeight - 2 * FIT_MARGIN - inset;
    const k = Math.max(
      MIN_ZOOM,
      Math.min(width / Math.max(box.width, 1), height / Math.max(box.height, 1), MAX_FIT_ZOOM),
    );
    await this.#area.area.zoom(k);
    await this.#area.area.translate(
      FIT_MARGIN + (width - box.width * k) / 2 - box.x * k,
      FIT_MARGIN + (height - box.height * k) / 2 - box.y * k,
    );
  }

  /** Zooms around the middle of what is seen. */
  async zoomTo(k: number): Promise<void> {
    const wanted = Math.min(MAX_ZOOM, Math.max(MIN_ZOOM, k));
    const { clientWidth, clientHeight } = this.container;
    const { x, y, k: old } = this.view.value;
    const factor = 1 - wanted / old;
    await this.#area.area.zoom(
      wanted,
      (clientWidth / 2 - x) * factor,
      (clientHeight / 2 - y) * factor,
    );
  }

  /** Puts a place of the canvas in the middle. */
  async centre({ x, y }: Point): Promise<void> {
    const { clientWidth, clientHeight } = this.container;
    const { k } = this.view.value;
    await this.#area.area.translate(clientWidth / 2 - x * k, clientHeight / 2 - y * k);
  }

  destroy(): void {
    clearTimeout(this.#layerTimer);
    this.#observer.disconnect();
    this.#area.destroy();
  }

  /** While it is panned, the canvas is a layer of its own, which moves without being drawn anew. */
  #keepLayer(): void {
    const { style } = this.#area.area.content.holder;
    style.willChange = 'transform';
    clearTimeout(this.#layerTimer);
    this.#layerTimer = setTimeout(() => (style.willChange = ''), LAYER_MS);
  }

  #pick(id: string): void {
    this.#handlers.picked(id);
    this.#dragged = id;
    const along = [id, ...this.#handlers.companions(id)];
    this.#start = new Map(
      along.flatMap((one) => {
        const position = this.positions.get(one);
        return position === undefined ? [] : [[one, position] as const];
      }),
    );
  }

  #takeAlong({ x, y }: Point): void {
    const start = this.#dragged === undefined ? undefined : this.#start.get(this.#dragged);
    if (start === undefined) return;
    for (const [id, from] of this.#start) {
      if (id === this.#dragged) continue;
      void this.#area.translate(id, { x: from.x + x - start.x, y: from.y + y - start.y });
    }
  }

  #drop(): void {
    const id = this.#dragged;
    if (id === undefined) return;
    this.#dragged = undefined;
    const from = this.#start.get(id);
    const to = this.positions.get(id);
    if (from === undefined || to === undefined || (from.x === to.x && from.y === to.y)) return;
    const by = { x: to.x - from.x, y: to.y - from.y };
    const places = [...this.#start].map(
      ([one, old]) => [one, { x: old.x + by.x, y: old.y + by.y }] as const,
    );
    this.#handlers.moved(new Map(places));
  }
}

function layer(name: string): HTMLElement {
  const element = document.createElement('div');
  element.className = `graph-layer graph-${name}`;
  return element;
}
