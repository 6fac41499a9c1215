import type { ProcessingModule } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../editor/graph-editor.ts';
import { fittingPorts } from '../model/fit/fitting.ts';
import type { Point, PortRef, Wire } from '../model/graph.ts';
import { wiresAt } from '../model/wires-of.ts';
import { portKey, type CanvasStage } from './canvas-stage.ts';
import { fitBetween, type PortFit } from './port-fit.ts';

/** A wire being pulled. */
export interface Pull {
  readonly from: PortRef;
  readonly side: 'in' | 'out';
  /** The wire whose end is being moved. */
  readonly moving: Wire | undefined;
  /** Where the free end is, on the canvas. */
  readonly end: Point;
  /** Ports that would take it, by `portKey`. */
  readonly fits: ReadonlySet<string>;
  readonly over: PortRef | undefined;
}

/** Why a wire was refused, where that was, and what would help. */
export interface Refusal {
  readonly fit: PortFit;
  /** On the page, pixels. */
  readonly clientX: number;
  readonly clientY: number;
}

/** Where a wire was let go over nothing: what fits may be added there. */
export interface Offer {
  readonly from: PortRef;
  readonly side: 'in' | 'out';
  readonly at: Point;
  readonly clientX: number;
  readonly clientY: number;
}

/** Pointers that move less than this have clicked, pixels. */
const CLICK_PX = 5;

/** Pulls wires: by dragging, or by a click on each end; with mouse, pen, finger and keyboard. */
export class ConnectGesture {
  readonly pull: ShallowRef<Pull | undefined> = shallowRef();
  readonly refusal: ShallowRef<Refusal | undefined> = shallowRef();
  readonly offer: ShallowRef<Offer | undefined> = shallowRef();
  readonly #editor: GraphEditor;
  readonly #stage: CanvasStage;
  #stop: (() => void) | undefined;

  /** Modules that may be offered to go in between. */
  readonly #library: () => readonly ProcessingModule[];

  constructor(editor: GraphEditor, stage: CanvasStage, library: () => readonly ProcessingModule[]) {
    this.#editor = editor;
    this.#stage = stage;
    this.#library = library;
  }

  /** A pointer went down on a socket. */
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

  /** Enter on a socket: takes up a wire, or ends it there. */
  pressKey(port: PortRef, element: HTMLElement): void {
    const { left, top } = element.getBoundingClientRect();
    const at = { clientX: left, clientY: top };
    if (this.pull.value === undefined) this.#take(port, at);
    else this.#finish(port, at);
  }

  cancel(): void {
    this.#stop?.();
    this.#stop = undefined;
    this.pull.value = undefined;
    this.refusal.value = undefined;
  }

  /** True when a port would not take the wire that is being pulled. */
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

  /** Connects two ports if they go together; else says why not. */
  connect(a: PortRef, b: PortRef, at: { clientX: number; clientY: number }, key?: string): boolean {
    const fit = this.#judged(a, b, at);
    if (fit === undefined) return false;
    this.#editor.apply({ kind: 'connect', from: fit.from, to: fit.to }, key);
    return true;
  }

  /** The fit, when there is one; else says why not. */
  #judged(a: PortRef, b: PortRef, at: { clientX: number; clientY: number }): PortFit | undefined {
    const fit = fitBetween(this.#editor.graph.value, a, b, this.#library());
    if (fit?.reason === undefined) return fit;
    this.refusal.value = { fit, clientX: at.clientX, clientY: at.clientY };
    return undefined;
  }

  #begin(port: PortRef, event: PointerEvent): void {
    const moving = this.#take(port, event);
    const start = { x: event.clientX, y: event.clientY };
    let isClick = true;
    const move = (next: PointerEvent): void => {
      if (Math.hypot(next.clientX - start.x, next.clientY - start.y) > CLICK_PX) isClick = false;
      this.#move(next);
    };
    const up = (next: PointerEvent): void => {
      if (isClick) {
        // A click on a wired input only touches it.
        if (moving) this.cancel();
        isClick = false;
        return;
      }
      const over = socketUnder(next);
      if (over !== undefined) this.#finish(over, next);
      else this.#drop(next);
    };
    const down = (next: PointerEvent): void => {
      if (next.target instanceof Element && next.target.closest('[data-port]')) return;
      // The second click of click and click, beside every socket.
      next.preventDefault();
      next.stopPropagation();
    };
    window.addEventListener('pointermove', move);
    window.addEventListener('pointerup', up);
    window.addEventListener('pointerdown', down, true);
    this.#stop = () => {
      window.removeEventListener('pointermove', move);
      window.removeEventListener('pointerup', up);
      window.removeEventListener('pointerdown', down, true);
    };
  }

  /** @returns true when it is the end of a wire that is there */
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
    this.pull.value = { ...pull, end, over: socketUnder(event) };
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

  /** Let go over nothing: a moved wire is taken off, a new one offers what fits. */
  #drop(event: PointerEvent): void {
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

/** The port under a pointer: its socket, or the row it belongs to. */
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
