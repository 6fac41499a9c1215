import type { ProcessingModule } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../editing/graph-editor.ts';
import { fittingPorts } from '../model/fit/fitting.ts';
import type { Point, PortRef, Wire } from '../model/graph.ts';
import { wiresAt } from '../model/wires-of.ts';
import { portKey, type CanvasStage } from './canvas-stage.ts';
import { fitBetween, type PortFit } from './port-fit.ts';

/** A wire being dragged. */
export interface Pull {
  readonly from: PortRef;
  readonly side: 'in' | 'out';
  /** Existing wire whose end is being moved. */
  readonly moving: Wire | undefined;
  /** Position of the free end on the canvas. */
  readonly end: Point;
  /** Ports that accept the wire, by `portKey`. */
  readonly fits: ReadonlySet<string>;
  readonly over: PortRef | undefined;
}

/** A refused wire: the reason, its position, and adapters that would make it fit. */
export interface Refusal {
  readonly fit: PortFit;
  /** On the page, pixels. */
  readonly clientX: number;
  readonly clientY: number;
}

/** A wire dropped on empty canvas, where a fitting node can be added. */
export interface Offer {
  readonly from: PortRef;
  readonly side: 'in' | 'out';
  readonly at: Point;
  readonly clientX: number;
  readonly clientY: number;
}

/** Input method that started a wire; the same one chooses its other end. */
export type Hand = 'mouse' | 'touch' | 'pen' | 'key';

/** Pointer movement up to which a press is a click, pixels. */
const CLICK_PX = 5;
/** The same for fingers, which are less steady. */
const TAP_PX = 10;
/** Distance from the centre of a socket within which a touch hits it, pixels: half of a touch target. */
export const FINGER_PX = 22;

const handOf = ({ pointerType }: PointerEvent): Hand =>
  pointerType === 'touch' || pointerType === 'pen' ? pointerType : 'mouse';

/** Creates wires: by dragging, or by a click on each end; with mouse, pen, finger and keyboard. */
export class ConnectGesture {
  readonly pull: ShallowRef<Pull | undefined> = shallowRef();
  readonly refusal: ShallowRef<Refusal | undefined> = shallowRef();
  readonly offer: ShallowRef<Offer | undefined> = shallowRef();
  /** Input method of a wire that was clicked at its start and waits for its end. */
  readonly waiting: ShallowRef<Hand | undefined> = shallowRef();
  readonly #editor: GraphEditor;
  readonly #stage: CanvasStage;
  #stop: (() => void) | undefined;

  /** Modules that can be offered as adapters. */
  readonly #library: () => readonly ProcessingModule[];

  constructor(editor: GraphEditor, stage: CanvasStage, library: () => readonly ProcessingModule[]) {
    this.#editor = editor;
    this.#stage = stage;
    this.#library = library;
  }

  /** Handles a pointer that goes down on a socket. */
  press(event: PointerEvent, port: PortRef): void {
    if (event.pointerType === 'mouse' && event.button !== 0) return;
    event.preventDefault();
    event.stopPropagation();
    if (this.pull.value !== undefined) {
      this.#finish(port, event);
      return;
    }
    this.#begin(port, event);
  }

  /** Enter on a socket: starts a wire, or ends it there. */
  pressKey(port: PortRef, element: HTMLElement): void {
    const { left, top } = element.getBoundingClientRect();
    const at = { clientX: left, clientY: top };
    if (this.pull.value !== undefined) {
      this.#finish(port, at);
      return;
    }
    this.#take(port, at);
    this.waiting.value = 'key';
  }

  /** A tap chose the end of the waiting wire. @returns false when there is none near */
  tap(at: { clientX: number; clientY: number }): boolean {
    const pull = this.pull.value;
    if (pull === undefined) return false;
    const port = this.nearestSocket(at) ?? socketUnder(at) ?? this.#onlyFitUnder(at);
    const under = document.elementFromPoint(at.clientX, at.clientY);
    if (port !== undefined && portKey(port) !== portKey(pull.from)) this.#finish(port, at);
    else if (port !== undefined) this.cancel();
    else if (under?.closest('[data-graph-node]')) return false;
    else this.#drop(at);
    return true;
  }

  /** Returns the socket nearest to a touch; where several overlap, fitting ones first. */
  nearestSocket({ clientX, clientY }: { clientX: number; clientY: number }): PortRef | undefined {
    const { x, y } = this.#stage.toCanvas(clientX, clientY);
    const reach = FINGER_PX / this.#stage.view.value.k;
    const fits = this.pull.value?.fits;
    let best: PortRef | undefined;
    let least = reach;
    for (const { id: node, ports } of this.#editor.graph.value.nodes.values()) {
      for (const { id: port, direction } of ports) {
        const ref = { node, port };
        if (!this.#stage.sockets.has(portKey(ref))) continue;
        const at = this.#stage.socketAt(ref, direction);
        if (at === undefined) continue;
        const bonus = fits?.has(portKey(ref)) === true ? 0.5 : 0;
        const far = Math.hypot(at.x - x, at.y - y) - bonus;
        if (far <= least) [best, least] = [ref, far];
      }
    }
    return best;
  }

  /** Returns the port of the touched node that accepts the wire, if exactly one does. */
  #onlyFitUnder({ clientX, clientY }: { clientX: number; clientY: number }): PortRef | undefined {
    const element = document.elementFromPoint(clientX, clientY);
    const node = element?.closest<HTMLElement>('[data-graph-node]')?.dataset['graphNode'];
    if (node === undefined) return undefined;
    const ports = this.#editor.graph.value.nodes.get(node)?.ports ?? [];
    const fitting = ports
      .map(({ id }) => ({ node, port: id }))
      .filter((ref) => this.pull.value?.fits.has(portKey(ref)) === true);
    return fitting.length === 1 ? fitting[0] : undefined;
  }

  cancel(): void {
    this.#stop?.();
    this.#stop = undefined;
    this.pull.value = undefined;
    this.waiting.value = undefined;
    this.refusal.value = undefined;
  }

  /** True when the port does not accept the wire being dragged. */
  isMisfit(port: PortRef): boolean {
    const pull = this.pull.value;
    if (pull === undefined || portKey(port) === portKey(pull.from)) return false;
    return !pull.fits.has(portKey(port));
  }

  isNodeMisfit(node: string): boolean {
    const pull = this.pull.value;
    if (pull === undefined || pull.from.node === node) return false;
    const ports = this.#editor.graph.value.nodes.get(node)?.ports ?? [];
    return ports.every(({ id }) => !pull.fits.has(portKey({ node, port: id })));
  }

  /** Connects two ports if they fit; otherwise shows the reason. */
  connect(a: PortRef, b: PortRef, at: { clientX: number; clientY: number }, key?: string): boolean {
    const fit = this.#judged(a, b, at);
    if (fit === undefined) return false;
    this.#editor.apply({ kind: 'connect', from: fit.from, to: fit.to }, key);
    return true;
  }

  /** Returns the fit, if there is one; otherwise shows the reason. */
  #judged(a: PortRef, b: PortRef, at: { clientX: number; clientY: number }): PortFit | undefined {
    const fit = fitBetween(this.#editor.graph.value, a, b, this.#library());
    if (fit?.reason === undefined) return fit;
    this.refusal.value = { fit, clientX: at.clientX, clientY: at.clientY };
    return undefined;
  }

  #begin(port: PortRef, event: PointerEvent): void {
    const moving = this.#take(port, event);
    const hand = handOf(event);
    const reach = hand === 'touch' ? TAP_PX : CLICK_PX;
    const start = { x: event.clientX, y: event.clientY };
    let isClick = true;
    /** Ignore other pointers, and those that choose the end, which `tap` handles. */
    const isOther = (next: PointerEvent): boolean =>
      this.waiting.value === undefined
        ? next.pointerId !== event.pointerId
        : next.pointerType === 'touch';
    const move = (next: PointerEvent): void => {
      if (isOther(next)) return;
      if (Math.hypot(next.clientX - start.x, next.clientY - start.y) > reach) isClick = false;
      if (!isClick) this.#move(next);
    };
    const up = (next: PointerEvent): void => {
      if (isOther(next)) return;
      if (isClick) {
        isClick = false;
        this.#wait(port, hand, moving);
        return;
      }
      const over = this.#socketUnder(next);
      if (over !== undefined) this.#finish(over, next);
      else this.#drop(next);
    };
    const down = (next: PointerEvent): void => {
      if (isOther(next) || this.waiting.value === undefined) return;
      if (next.target instanceof Element && next.target.closest('[data-port], [data-wire-hint]'))
        return;
      // The second of two clicks, away from all sockets.
      next.preventDefault();
      next.stopPropagation();
    };
    const lost = (next: PointerEvent): void => {
      if (next.pointerId === event.pointerId && this.waiting.value === undefined) this.cancel();
    };
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', up);
    window.addEventListener('pointerdown', down, true);
    window.addEventListener('pointercancel', lost);
    this.#stop = () => {
      window.removeEventListener('pointermove', move);
      window.removeEventListener('pointerup', up);
      window.removeEventListener('pointerdown', down, true);
      window.removeEventListener('pointercancel', lost);
    };
  }

  /** A click at one end: the next click chooses the other. */
  #wait(port: PortRef, hand: Hand, moving: boolean): void {
    if (!moving) {
      this.waiting.value = hand;
    } else if (hand === 'mouse') {
      // A mouse click on a wired input changes nothing.
      this.cancel();
    } else {
      // A tap on a wired input asks for another source; the wire stays until one is chosen.
      const pull = this.pull.value;
      const fits = new Set(fittingPorts(this.#editor.graph.value, port).map(portKey));
      if (pull) this.pull.value = { ...pull, from: port, side: 'in', moving: undefined, fits };
      this.waiting.value = hand;
    }
  }

  #socketUnder(event: PointerEvent): PortRef | undefined {
    const near = event.pointerType === 'touch' ? this.nearestSocket(event) : undefined;
    return near ?? socketUnder(event);
  }

  /** @returns true when the port is the end of an existing wire */
  #take(port: PortRef, at: { clientX: number; clientY: number }): boolean {
    this.cancel();
    this.offer.value = undefined;
    const { graph } = this.#editor;
    const own = graph.value.nodes.get(port.node)?.ports.find(({ id }) => id === port.port);
    if (own === undefined) return false;
    const node = graph.value.nodes.get(port.node);
    const wired = own.direction === 'in' && node?.kind === 'module';
    const moving = wired ? wiresAt(graph.value, port)[0] : undefined;
    const from = moving?.from ?? port;
    const side = moving === undefined ? own.direction : 'out';
    this.pull.value = {
      from,
      side,
      moving,
      end: this.#stage.toCanvas(at.clientX, at.clientY),
      fits: new Set(fittingPorts(graph.value, from).map(portKey)),
      over: undefined,
    };
    return moving !== undefined;
  }

  #move(event: PointerEvent): void {
    const pull = this.pull.value;
    if (pull === undefined) return;
    this.refusal.value = undefined;
    const end = this.#stage.toCanvas(event.clientX, event.clientY);
    this.pull.value = { ...pull, end, over: this.#socketUnder(event) };
  }

  #finish(port: PortRef, at: { clientX: number; clientY: number }): void {
    const pull = this.pull.value;
    this.cancel();
    if (pull === undefined) return;
    const { moving, from } = pull;
    if (moving === undefined) {
      this.connect(from, port, at);
      return;
    }
    if (portKey(moving.to) === portKey(port)) return;
    const fit = this.#judged(from, port, at);
    if (fit === undefined) return;
    this.#editor.apply({
      kind: 'all',
      label: 'Move a wire',
      commands: [
        { kind: 'remove', wires: [moving.id] },
        { kind: 'connect', from: fit.from, to: fit.to },
      ],
    });
  }

  /** Dropped on empty canvas: disconnects a moved wire, offers fitting nodes for a new one. */
  #drop(event: { clientX: number; clientY: number }): void {
    const pull = this.pull.value;
    this.cancel();
    if (pull === undefined) return;
    if (pull.moving !== undefined) {
      this.#editor.apply({ kind: 'remove', wires: [pull.moving.id] });
      return;
    }
    const { from, side } = pull;
    const { clientX, clientY } = event;
    if (!this.#stage.container.contains(document.elementFromPoint(clientX, clientY))) return;
    this.offer.value = { from, side, at: this.#stage.toCanvas(clientX, clientY), clientX, clientY };
  }
}

/** Port under a pointer: its socket, or its row. */
export function socketUnder({
  clientX,
  clientY,
}: {
  clientX: number;
  clientY: number;
}): PortRef | undefined {
  const element = document.elementFromPoint(clientX, clientY);
  const found = element?.closest<HTMLElement>('[data-port], [data-row-port]');
  const { node, port, rowPort } = found?.dataset ?? {};
  const id = port ?? rowPort;
  return node === undefined || id === undefined ? undefined : { node, port: id };
}
