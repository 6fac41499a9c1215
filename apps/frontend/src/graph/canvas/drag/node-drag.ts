import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import { applyCommand } from '../../model/commands/apply-command.ts';
import type { Graph, Point } from '../../model/graph.ts';
import { bounds, type Box } from '../../model/selection/arrange.ts';
import { dropNodes } from '../../model/selection/drop-nodes.ts';
import { frameUnder } from '../../model/selection/frames.ts';
import { pointsGoingAlong } from '../../model/selection/move.ts';
import { withContents } from '../../model/nesting.ts';
import { detach } from '../../model/selection/reconnect.ts';
import { wiresOf } from '../../model/wires-of.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { GRID } from '../free-spot.ts';
import { EdgePan } from './edge-pan.ts';
import { followPointer, isClick } from './follow-pointer.ts';
import { snapMove, type GuideLine } from './guides.ts';
import type { InsertTarget } from './insert-target.ts';
import { Shake } from './shake.ts';

const NONE: ReadonlySet<string> = new Set();
const NO_WAY: Point = { x: 0, y: 0 };
/** Largest distances for alignment and for insertion into a wire, pixels. */
const GUIDE_PX = 6;
const WIRE_PX = 26;

/** Nodes being dragged. */
interface Held {
  /** Id of the node under the pointer. */
  readonly id: string;
  /** Canvas position where the pointer went down. */
  readonly grip: Point;
  /** Boxes at the start of the drag. */
  boxes: readonly Box[];
  /** Visible boxes of nodes that are not dragged. */
  readonly others: readonly Box[];
  readonly shake: Shake;
  isDetached: boolean;
}

/** Drags nodes: aligns them, inserts them into wires and frames, disconnects them. */
export class NodeDrag {
  /** Distance from their original positions. */
  readonly by: ShallowRef<Point> = shallowRef(NO_WAY);
  readonly lines: ShallowRef<readonly GuideLine[]> = shallowRef([]);
  /** Id of the frame they would join. */
  readonly frame: ShallowRef<string | undefined> = shallowRef();
  /** Ids of wires whose bend points move along. */
  readonly taken: ShallowRef<ReadonlySet<string>> = shallowRef(NONE);
  /** Ids of wires that are disconnected. */
  readonly loose: ShallowRef<ReadonlySet<string>> = shallowRef(NONE);
  /** True while a pointer is down on a node: focus changes come from it. */
  isPressed = false;
  readonly #editor: GraphEditor;
  readonly #stage: CanvasStage;
  readonly #target: InsertTarget;
  readonly #edge: EdgePan;
  #held: Held | undefined;
  #cancel: (() => void) | undefined;

  constructor(editor: GraphEditor, stage: CanvasStage, target: InsertTarget) {
    this.#editor = editor;
    this.#stage = stage;
    this.#target = target;
    this.#edge = new EdgePan(stage, (event) => this.#move(event));
  }

  /** Handles a pointer that goes down on a node. With Alt, disconnects its wires. */
  press(start: PointerEvent, id: string): void {
    this.#cancel?.();
    const { nodes } = this.#editor.selection.value;
    const isByFinger = this.#stage.isSelecting.value && start.pointerType !== 'mouse';
    const isAdding = start.shiftKey || start.ctrlKey || start.metaKey || isByFinger;
    if (isAdding) {
      this.#editor.select(nodes.has(id) ? [...nodes].filter((one) => one !== id) : [...nodes, id]);
    } else if (!nodes.has(id)) {
      this.#editor.select([id]);
    }
    this.isPressed = true;
    this.#cancel = followPointer(start, {
      move: (event) => {
        if (this.#held === undefined) {
          if (isClick(start, event)) return;
          this.#begin(start, id);
        }
        this.#move(event);
      },
      drop: () => {
        if (this.#held !== undefined) this.#drop();
        else if (!isAdding && nodes.size > 1) this.#editor.select([id]);
        this.#end();
      },
      cancel: () => {
        const { boxes = [] } = this.#held ?? {};
        this.#stage.put(boxes.map(({ id: one, x, y }) => [one, { x, y }]));
        this.#end();
      },
    });
  }

  /** Restores all positions, also of nodes that were only pressed. */
  cancel(): void {
    this.#cancel?.();
  }

  /** Handles a changed graph: releases removed nodes. */
  handleGraph(): void {
    const held = this.#held;
    if (held === undefined) return;
    const graph = this.#editor.graph.value;
    held.boxes = held.boxes.filter(({ id }) => graph.nodes.has(id));
    if (graph.nodes.has(held.id)) this.#look(held);
    else this.cancel();
  }

  #begin(start: PointerEvent, id: string): void {
    const graph = this.#editor.graph.value;
    const { nodes } = this.#editor.selection.value;
    const ids = withContents(graph, nodes.has(id) ? nodes : [id]);
    const seen = this.#stage.seen;
    const all = this.#stage.boxes();
    const isNear = (box: Box): boolean =>
      box.x < seen.x + seen.width &&
      box.x + box.width > seen.x &&
      box.y < seen.y + seen.height &&
      box.y + box.height > seen.y;
    this.#held = {
      id,
      grip: this.#stage.toCanvas(start.clientX, start.clientY),
      boxes: all.filter((box) => ids.has(box.id)),
      others: all.filter(
        (box) => !ids.has(box.id) && isNear(box) && graph.nodes.get(box.id)?.kind !== 'frame',
      ),
      shake: new Shake(),
      isDetached: start.altKey,
    };
    this.#stage.hold(ids);
    this.#look(this.#held);
  }

  /** Determines the wires that the drag affects. */
  #look({ id, boxes, isDetached }: Held): void {
    const graph = this.#editor.graph.value;
    const ids = new Set(boxes.map((box) => box.id));
    const free = isDetached ? applyCommand(graph, detach(graph, [...ids])).graph : graph;
    this.taken.value = new Set(pointsGoingAlong(free, ids));
    this.loose.value = isDetached ? wiresBetween(graph, ids) : NONE;
    this.#target.end();
    const node = free.nodes.get(id);
    // A node that has targets already is not inserted into the wires it passes.
    if (boxes.length === 1 && node !== undefined && wiresOf(free, id).out.length === 0)
      this.#target.begin(free, node);
  }

  #move(event: PointerEvent): void {
    const held = this.#held;
    const grabbed = held?.boxes.find(({ id }) => id === held.id);
    if (held === undefined || grabbed === undefined) return;
    const { k } = this.#stage.view.value;
    const { x, y } = this.#stage.toCanvas(event.clientX, event.clientY);
    const { by, lines } = snapMove(
      { id: '', ...bounds(held.boxes) },
      { x: x - held.grip.x, y: y - held.grip.y },
      {
        others: held.others,
        reach: event.altKey ? 0 : GUIDE_PX / k,
        grid: GRID,
        anchor: grabbed,
      },
    );
    this.#edge.update(event);
    this.by.value = by;
    this.lines.value = lines;
    this.#stage.put(held.boxes.map((box) => [box.id, { x: box.x + by.x, y: box.y + by.y }]));
    if (!held.isDetached && held.shake.add(event.clientX, event.timeStamp)) {
      held.isDetached = true;
      this.#look(held);
    }
    const now = { ...grabbed, x: grabbed.x + by.x, y: grabbed.y + by.y };
    const middle = { x: now.x + now.width / 2, y: now.y + now.height / 2 };
    this.#target.over(middle, Math.max(WIRE_PX / k, now.height / 2));
    this.frame.value = frameUnder(this.#editor.graph.value.nodes, now, this.#frames());
  }

  #drop(): void {
    const held = this.#held;
    if (held === undefined) return;
    const by = this.by.value;
    if (by.x === 0 && by.y === 0 && !held.isDetached) return;
    const boxes = held.boxes.map((box) => ({ ...box, x: box.x + by.x, y: box.y + by.y }));
    const on = this.#target.end();
    const moved = new Set(boxes.map(({ id }) => id));
    const others = this.#stage.boxes().filter(({ id }) => !moved.has(id));
    const drop = { boxes, frames: this.#frames(), by, isDetached: held.isDetached, on, others };
    this.#editor.apply(dropNodes(this.#editor.graph.value, drop));
  }

  #end(): void {
    this.isPressed = false;
    this.#cancel = undefined;
    this.#edge.stop();
    this.#target.end();
    if (this.#held === undefined) return;
    this.#held = undefined;
    this.by.value = NO_WAY;
    this.lines.value = [];
    this.frame.value = undefined;
    this.taken.value = NONE;
    this.loose.value = NONE;
    this.#stage.hold(NONE);
    void this.#stage.show(this.#editor.places.value);
  }

  #frames(): Box[] {
    const { nodes } = this.#editor.graph.value;
    return this.#stage.boxes().filter(({ id }) => nodes.get(id)?.kind === 'frame');
  }
}

/** Returns the wires with exactly one end at these nodes. */
function wiresBetween(graph: Graph, ids: ReadonlySet<string>): ReadonlySet<string> {
  const found = new Set<string>();
  for (const id of ids) {
    const { in: incoming, out } = wiresOf(graph, id);
    for (const { id: wire, from, to } of [...incoming, ...out]) {
      if (!ids.has(from.node) || !ids.has(to.node)) found.add(wire);
    }
  }
  return found;
}
