import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { Point, Wire } from '../../model/graph.ts';
import type { Box } from '../../model/selection/arrange.ts';
import { addPoint, movePoint, removePoint } from '../../model/selection/wire-points.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { followPointer, isClick } from '../drag/follow-pointer.ts';
import { snapMove, type GuideLine } from '../drag/guides.ts';
import { spotsOnStage } from '../drag/insert-target.ts';
import { GRID, onGrid } from '../free-spot.ts';
import { nearestOn, roomiest } from '../wire-hit.ts';

/** Bend point of a wire. */
export interface WirePoint {
  readonly wire: string;
  readonly index: number;
}

const GUIDE_PX = 6;

/** Adds, drags and removes bend points of wires, with pointers and keys. */
export class WirePoints {
  /** Bend points of a wire while one of them is dragged. */
  readonly shown: ShallowRef<
    { readonly wire: string; readonly points: readonly Point[] } | undefined
  > = shallowRef();
  readonly lines: ShallowRef<readonly GuideLine[]> = shallowRef([]);
  readonly #picked: ShallowRef<WirePoint | undefined> = shallowRef();
  readonly #editor: GraphEditor;
  readonly #stage: CanvasStage;
  #cancel: (() => void) | undefined;

  constructor(editor: GraphEditor, stage: CanvasStage) {
    this.#editor = editor;
    this.#stage = stage;
  }

  /** Bend point that keys apply to, while it exists and its wire is selected. */
  get selected(): WirePoint | undefined {
    const picked = this.#picked.value;
    if (picked === undefined || this.#editor.selection.value.wire !== picked.wire) return undefined;
    const wire = this.#editor.graph.value.wires.get(picked.wire);
    return wire !== undefined && picked.index < wire.points.length ? picked : undefined;
  }

  select(point: WirePoint | undefined): void {
    this.#picked.value = point;
    if (point !== undefined) this.#editor.selectWire(point.wire);
  }

  /** Handles a pointer that goes down on a bend point. */
  press(start: PointerEvent, point: WirePoint): void {
    this.select(point);
    const wire = this.#wire(point.wire);
    const at = wire?.points[point.index];
    if (wire === undefined || at === undefined) return;
    this.#follow(start, wire.points, point, at, (to) => movePoint(wire, point.index, to));
  }

  /** Handles a pointer that goes down on a wire: dragging adds a bend point there. */
  pressWire(start: PointerEvent, id: string): void {
    this.select(undefined);
    this.#editor.selectWire(id);
    const wire = this.#wire(id);
    const place = this.#stage.toCanvas(start.clientX, start.clientY);
    const spot = wire && nearestOn(spotsOnStage(this.#stage, wire), place);
    if (wire === undefined || spot === undefined) return;
    const { x, y, leg } = spot;
    const points = wire.points.toSpliced(leg, 0, { x, y });
    this.#follow(start, points, { wire: id, index: leg }, { x, y }, (to) =>
      addPoint(wire, leg, to),
    );
  }

  /** Adds a bend point where a wire is nearest to a position; default: where it has most room. */
  add(id: string, place?: Point): void {
    const wire = this.#wire(id);
    const [start, end] = wire
      ? [this.#stage.socketAt(wire.from, 'out'), this.#stage.socketAt(wire.to, 'in')]
      : [];
    if (wire === undefined || start === undefined || end === undefined) return;
    const spot = place
      ? nearestOn(spotsOnStage(this.#stage, wire), place)
      : roomiest(start, end, wire.points);
    if (spot === undefined) return;
    this.#editor.apply(addPoint(wire, spot.leg, onGrid(spot)));
    this.select({ wire: id, index: spot.leg });
  }

  remove({ wire: id, index }: WirePoint): void {
    const wire = this.#wire(id);
    if (wire === undefined || index >= wire.points.length) return;
    this.#editor.apply(removePoint(wire, index));
    this.select(wire.points.length > 1 ? { wire: id, index: Math.max(0, index - 1) } : undefined);
    this.#editor.selectWire(id);
  }

  /** Selects the next or previous bend point of the selected wire. */
  walk(step: 1 | -1): boolean {
    const { wire: id } = this.#editor.selection.value;
    const count = (id === undefined ? undefined : this.#wire(id)?.points.length) ?? 0;
    if (id === undefined || count === 0) return false;
    const index = this.selected?.index ?? (step > 0 ? -1 : count);
    this.select({ wire: id, index: (index + step + count) % count });
    return true;
  }

  /** Moves the selected bend point; consecutive moves are one undo step. */
  move(by: Point): boolean {
    const point = this.selected;
    const wire = point && this.#wire(point.wire);
    const at = point && wire?.points[point.index];
    if (point === undefined || wire === undefined || at === undefined) return false;
    const to = { x: at.x + by.x, y: at.y + by.y };
    const key = `point ${point.wire} ${point.index}`;
    this.#editor.apply(movePoint(wire, point.index, to), key);
    return true;
  }

  cancel(): void {
    this.#cancel?.();
  }

  /** Handles a changed graph: releases a removed bend point. */
  handleGraph(): void {
    const shown = this.shown.value;
    if (shown !== undefined && this.#wire(shown.wire) !== this.#followed) this.cancel();
  }

  /** Wire whose bend point is dragged, as at the start of the drag. */
  #followed: Wire | undefined;

  #wire(id: string): Wire | undefined {
    return this.#editor.graph.value.wires.get(id);
  }

  #follow(
    start: PointerEvent,
    points: readonly Point[],
    point: WirePoint,
    at: Point,
    commandFor: (to: Point) => Parameters<GraphEditor['apply']>[0],
  ): void {
    this.cancel();
    const grip = this.#stage.toCanvas(start.clientX, start.clientY);
    const others = this.#neighbours(points, point);
    let to: Point | undefined;
    this.#cancel = followPointer(start, {
      move: (event) => {
        if (to === undefined && isClick(start, event)) return;
        this.#followed ??= this.#wire(point.wire);
        const { x, y } = this.#stage.toCanvas(event.clientX, event.clientY);
        const way = { x: x - grip.x, y: y - grip.y };
        const reach = event.altKey ? 0 : GUIDE_PX / this.#stage.view.value.k;
        const options = { others, reach, grid: GRID, anchor: at };
        const { by, lines } = snapMove({ id: '', ...at, width: 0, height: 0 }, way, options);
        to = { x: at.x + by.x, y: at.y + by.y };
        this.lines.value = lines;
        this.shown.value = { wire: point.wire, points: points.with(point.index, to) };
      },
      drop: () => {
        if (to !== undefined) {
          this.#editor.apply(commandFor(to));
          this.select(point);
        }
        this.#end();
      },
      cancel: () => this.#end(),
    });
  }

  /** Alignment targets of a bend point: the other bend points and the ends of its wire. */
  #neighbours(points: readonly Point[], { wire: id, index }: WirePoint): Box[] {
    const wire = this.#wire(id);
    const ends = wire
      ? [this.#stage.socketAt(wire.from, 'out'), this.#stage.socketAt(wire.to, 'in')]
      : [];
    return [...points.toSpliced(index, 1), ...ends].flatMap((point) =>
      point === undefined ? [] : [{ id: '', x: point.x, y: point.y, width: 0, height: 0 }],
    );
  }

  #end(): void {
    this.#cancel = undefined;
    this.#followed = undefined;
    this.shown.value = undefined;
    this.lines.value = [];
  }
}
