import { plural } from '@ubii/words';

import { randomUuid } from '../../connection/random-uuid.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';
import { commandLabel } from '../model/commands/command-label.ts';
import type { Point } from '../model/graph.ts';
import {
  align,
  bounds,
  distribute,
  type Alignment,
  type Axis,
} from '../model/selection/arrange.ts';
import { areaAround, frameAround, resizeFrame } from '../model/selection/frames.ts';
import { insertOnWire } from '../model/selection/insert.ts';
import { moveTogether } from '../model/selection/move.ts';
import { withContents } from '../model/nesting.ts';
import { detach, removeAndReconnect } from '../model/selection/reconnect.ts';
import { removePoints } from '../model/selection/wire-points.ts';
import type { CanvasStage } from './canvas-stage.ts';
import { InsertTarget } from './drag/insert-target.ts';
import { limitSize } from './frames/resize-box.ts';
import type { WirePoint, WirePoints } from './points/wire-points.ts';

/** Commands of menus and keys on the selection, using drawn sizes and positions. Each is one undo step. */
export class CanvasCommands {
  readonly #editor: GraphEditor;
  readonly #stage: CanvasStage;
  readonly #points: WirePoints;

  constructor(editor: GraphEditor, stage: CanvasStage, points: WirePoints) {
    this.#editor = editor;
    this.#stage = stage;
    this.#points = points;
  }

  /** Adds a bend point to a wire. @param place on the canvas; default: where the wire has most room */
  addPoint(wire: string, place?: Point): void {
    this.#points.add(wire, place);
  }

  removePoint(point: WirePoint): void {
    this.#points.remove(point);
  }

  /** Removes all bend points of a wire. */
  straighten(id: string): void {
    const wire = this.#editor.graph.value.wires.get(id);
    if (wire !== undefined && wire.points.length > 0) this.#editor.apply(removePoints(wire));
  }

  /** Puts a frame around the selection; when one frame is selected with other nodes, moves those into it. */
  frame(): boolean {
    const graph = this.#editor.graph.value;
    const selected = this.#selected();
    const frames = selected.filter((id) => graph.nodes.get(id)?.kind === 'frame');
    const inside = withContents(graph, frames);
    const boxes = this.#stage.boxes(selected.filter((id) => !inside.has(id)));
    const [into, ...more] = frames;
    if (into === undefined || more.length > 0 || boxes.length === 0) {
      const all = this.#stage.boxes(selected);
      if (all.length === 0) return false;
      const id = `frame:${randomUuid()}`;
      this.#editor.apply(frameAround(graph, all, id));
      this.#editor.select([id]);
      return true;
    }
    const nodes = boxes.map(({ id }) => id);
    const put = { kind: 'setFrame', nodes, frame: into } as const;
    const { x, y, ...size } = bounds([areaAround(boxes), ...this.#stage.boxes([into])]);
    const grown = { kind: 'resize', node: into, size, position: { x, y } } as const;
    this.#editor.apply({ kind: 'all', label: commandLabel(graph, put), commands: [grown, put] });
    return true;
  }

  /** Removes the selected frames and keeps their contents. */
  unframe(): boolean {
    const { nodes } = this.#editor.graph.value;
    const frames = this.#selected().filter((id) => nodes.get(id)?.kind === 'frame');
    if (frames.length === 0) return false;
    const label = plural(frames.length, 'Remove the frame', `Remove ${frames.length} frames`);
    const inside = [...nodes.values()].filter(({ frame }) => frames.includes(frame ?? ''));
    const commands = frames.map((frame) => ({ kind: 'ungroup', frame }) as const);
    this.#editor.apply({ kind: 'all', label, commands });
    this.#editor.select(inside.map(({ id }) => id));
    return true;
  }

  /** Disconnects the selected nodes, and connects their sources to their targets. */
  detach(): boolean {
    const ids = this.#selected();
    if (ids.length === 0) return false;
    this.#editor.apply(detach(this.#editor.graph.value, ids));
    return true;
  }

  /** Inserts a node into a wire; false when it does not fit. @param leg number of bend points before it */
  insertOn(wire: string, id: string, leg = 0): boolean {
    const graph = this.#editor.graph.value;
    const node = graph.nodes.get(id);
    const command = node && insertOnWire(graph, wire, node, leg, this.#stage.boxes());
    if (command === undefined) return false;
    this.#editor.apply(command);
    return true;
  }

  /** Inserts the selected node into the wire it lies on. */
  insert(): boolean {
    const [only, ...others] = this.#selected();
    const node = only === undefined ? undefined : this.#editor.graph.value.nodes.get(only);
    const [box] = only === undefined ? [] : this.#stage.boxes([only]);
    if (node === undefined || box === undefined || others.length > 0) return false;
    const target = new InsertTarget(this.#stage);
    target.begin(this.#editor.graph.value, node);
    target.over({ x: box.x + box.width / 2, y: box.y + box.height / 2 }, box.height);
    const on = target.end();
    return on !== undefined && this.insertOn(on.wire, node.id, on.leg);
  }

  align(alignment: Alignment): boolean {
    return this.#place(align(this.#stage.boxes(this.#selected()), alignment));
  }

  distribute(axis: Axis): boolean {
    return this.#place(distribute(this.#stage.boxes(this.#selected()), axis));
  }

  /** Moves the selection; consecutive moves are one undo step. */
  move(by: Point): boolean {
    const graph = this.#editor.graph.value;
    const places = this.#editor.places.value;
    const ids = withContents(graph, this.#selected());
    if (ids.size === 0) return this.#points.move(by);
    const moved = [...ids].map((id) => {
      const { x, y } = places.get(id) ?? { x: 0, y: 0 };
      return [id, { x: x + by.x, y: y + by.y }] as const;
    });
    const key = `move ${[...ids].join(' ')}`;
    this.#editor.apply(moveTogether(graph, new Map(moved), by), key);
    return true;
  }

  /** Resizes the selected frame or note. */
  resize(by: Point): boolean {
    const [only, ...others] = this.#selected();
    const node = only === undefined ? undefined : this.#editor.graph.value.nodes.get(only);
    const [box] = only === undefined ? [] : this.#stage.boxes([only]);
    if (node === undefined || box === undefined || others.length > 0) return false;
    if (node.kind !== 'frame' && node.kind !== 'comment') return false;
    const { id, x, y } = box;
    const wanted = { width: box.width + by.x, height: box.height + by.y };
    const size = limitSize(node.kind, wanted);
    const command =
      node.kind === 'frame'
        ? resizeFrame(this.#editor.graph.value, node, { x, y, ...size }, this.#stage.boxes())
        : ({ kind: 'resize', node: id, size } as const);
    this.#editor.apply(command, `resize ${id}`);
    return true;
  }

  /** @param reconnect connects the sources of the nodes to their targets */
  remove(reconnect: boolean): boolean {
    const { wire } = this.#editor.selection.value;
    const point = this.#points.selected;
    const nodes = this.#selected();
    if (point !== undefined) this.#points.remove(point);
    else if (wire !== undefined) this.#editor.apply({ kind: 'remove', wires: [wire] });
    else if (nodes.length === 0) return false;
    else if (reconnect) this.#editor.apply(removeAndReconnect(this.#editor.graph.value, nodes));
    else this.#editor.apply({ kind: 'remove', nodes });
    return true;
  }

  #selected(): string[] {
    return [...this.#editor.selection.value.nodes];
  }

  #place(positions: ReadonlyMap<string, Point>): boolean {
    if (positions.size > 0) this.#editor.apply({ kind: 'move', positions });
    return this.#selected().length > 1;
  }
}
