import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { Graph, Point, Port, PortRef } from '../../model/graph.ts';
import { openInput } from '../../model/open-input.ts';
import { portOf } from '../../model/port-format.ts';
import { wiresAt, wiresOf } from '../../model/wires-of.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { viewShowing } from '../view-showing.ts';
import { firstIn, neighbour } from './neighbour.ts';

/** Node, or one of its sockets, that has the keyboard focus. */
export interface KeyPlace {
  readonly node: string;
  readonly port: string | undefined;
}

/** Most animation frames to wait until a socket that scrolls into view is rendered. */
const MAX_FRAMES = 12;

/**
 * Moves the focus with arrow keys: from node to node, and in the direction of the data from a node to its sockets and
 * along their wires. The focused node is selected and brought into view.
 */
export class KeyWalk {
  /** Focused node or socket. */
  readonly at: ShallowRef<KeyPlace | undefined> = shallowRef();
  readonly #editor: GraphEditor;
  readonly #stage: CanvasStage;

  constructor(editor: GraphEditor, stage: CanvasStage) {
    this.#editor = editor;
    this.#stage = stage;
  }

  /** @param target of the key event @returns false when nothing lies in that direction */
  arrow(target: HTMLElement, way: Point): boolean {
    const place = placeOf(target);
    if (place === undefined) return this.#enter();
    const port = place.port === undefined ? undefined : this.#portOf(place.node, place.port);
    if (port === undefined) return this.#fromNode(place.node, way);
    return this.#fromSocket({ node: place.node, port: port.id }, port, way);
  }

  /** Moves the focus from a socket to its node. @returns false when no socket has the focus */
  leaveSocket(target: HTMLElement): boolean {
    const place = placeOf(target);
    if (place?.port === undefined) return false;
    void this.focusNode(place.node);
    return true;
  }

  /** Returns the focused socket; for a node, the socket at which a new wire starts. */
  socketFor(target: HTMLElement): PortRef | undefined {
    const place = placeOf(target);
    const [only, ...others] = this.#editor.selection.value.nodes;
    const node = place?.node ?? (others.length === 0 ? only : undefined);
    if (node === undefined) return undefined;
    if (place?.port !== undefined) return { node, port: place.port };
    const port = startOf(this.#editor.graph.value, node);
    return port && { node, port: port.id };
  }

  async focusNode(id: string): Promise<void> {
    await this.#stage.show(this.#editor.places.value);
    await this.#reveal(id);
    await this.#focus(() => this.#stage.elements.get(id)?.querySelector('[data-graph-node]'));
  }

  async focusSocket(ref: PortRef): Promise<void> {
    if (!this.#editor.selection.value.nodes.has(ref.node)) this.#editor.select([ref.node]);
    await this.#reveal(ref.node);
    const selector = `.socket[data-port="${CSS.escape(ref.port)}"]`;
    const isFound = await this.#focus(() =>
      this.#stage.elements.get(ref.node)?.querySelector(selector),
    );
    if (!isFound) await this.focusNode(ref.node);
  }

  /** Moves the focus from the canvas to the selection, otherwise to the first visible node. */
  #enter(): boolean {
    const [selected] = this.#editor.selection.value.nodes;
    const id = selected ?? firstIn(this.#stage.boxes(), this.#stage.seen)?.id;
    if (id === undefined) return false;
    void this.focusNode(id);
    return true;
  }

  #fromNode(node: string, way: Point): boolean {
    if (way.x !== 0) {
      const side = way.x > 0 ? 'out' : 'in';
      const [port] = this.#ports(node, side);
      if (port !== undefined) {
        void this.focusSocket({ node, port: port.id });
        return true;
      }
    }
    return this.#toNeighbour(node, way);
  }

  #fromSocket(ref: PortRef, { direction }: Port, way: Point): boolean {
    const outward = direction === 'out' ? 1 : -1;
    if (way.x === -outward) {
      void this.focusNode(ref.node);
      return true;
    }
    if (way.x === outward) {
      const [wire] = wiresAt(this.#editor.graph.value, ref);
      if (wire === undefined) return this.#toNeighbour(ref.node, way);
      void this.focusSocket(direction === 'out' ? wire.to : wire.from);
      return true;
    }
    const ports = this.#ports(ref.node, direction);
    const next = ports[ports.findIndex(({ id }) => id === ref.port) + way.y];
    if (next === undefined) return this.#toNeighbour(ref.node, way);
    void this.focusSocket({ node: ref.node, port: next.id });
    return true;
  }

  #toNeighbour(node: string, way: Point): boolean {
    const boxes = this.#stage.boxes();
    const from = boxes.find(({ id }) => id === node);
    const next = from && neighbour(boxes, from, way);
    // At the edge the key is handled, too, so that the page does not scroll.
    if (next !== undefined) void this.focusNode(next.id);
    return true;
  }

  #ports(node: string, side: Port['direction']): Port[] {
    const ports = this.#editor.graph.value.nodes.get(node)?.ports ?? [];
    return ports.filter(({ direction }) => direction === side);
  }

  #portOf(node: string, port: string): Port | undefined {
    return portOf(this.#editor.graph.value, { node, port });
  }

  async #reveal(id: string): Promise<void> {
    const [box] = this.#stage.boxes([id]);
    const { view, viewport } = this.#stage;
    const next = box && viewShowing(view.value, viewport.value, box);
    if (next !== undefined) await this.#stage.look(next);
  }

  /** Waits until the element is rendered, and focuses it. @returns whether it was rendered */
  async #focus(find: () => HTMLElement | null | undefined): Promise<boolean> {
    for (let frame = 0; frame < MAX_FRAMES; frame += 1) {
      const element = find();
      if (element) {
        // Otherwise browsers scroll the canvas, which is panned instead.
        element.focus({ preventScroll: true });
        return true;
      }
      await new Promise((resolve) => requestAnimationFrame(resolve));
    }
    return false;
  }
}

/** Node or socket that an element belongs to. */
export function placeOf(element: Element): KeyPlace | undefined {
  const node = element.closest<HTMLElement>('[data-graph-node]')?.dataset['graphNode'];
  if (node === undefined) return undefined;
  const port = element.closest<HTMLElement>('.socket[data-port]')?.dataset['port'];
  return { node, port };
}

/**
 * Returns the port at which a wire requested for a node starts: the main input if it has no wire, otherwise the first
 * unwired output, otherwise the first unwired input.
 */
export function startOf(graph: Graph, node: string): Port | undefined {
  const ports = graph.nodes.get(node)?.ports ?? [];
  const { in: incoming, out } = wiresOf(graph, node);
  const isFree = ({ id }: Port): boolean =>
    !incoming.some(({ to }) => to.port === id) && !out.some(({ from }) => from.port === id);
  const outputs = ports.filter(({ direction }) => direction === 'out');
  const inputs = ports.filter(({ direction }) => direction === 'in');
  const main = openInput(graph, graph.nodes.get(node));
  return main ?? outputs.find(isFree) ?? inputs.find(isFree) ?? outputs[0] ?? inputs[0];
}
