import { shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor } from '../../editing/graph-editor.ts';
import type { CommentNode, FrameNode } from '../../model/graph.ts';
import { resizeFrame } from '../../model/selection/frames.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import { followPointer, isClick } from '../drag/follow-pointer.ts';
import { GRID } from '../free-spot.ts';
import type { Box } from '../stage-view.ts';
import { resizeBox, type Handle } from './resize-box.ts';

const snap = (value: number): number => Math.round(value / GRID) * GRID;

/** Resizes frames and notes by their handles. */
export class NodeResize {
  /** Box of the node being resized. */
  readonly shown: ShallowRef<{ readonly id: string; readonly box: Box } | undefined> = shallowRef();
  readonly #editor: GraphEditor;
  readonly #stage: CanvasStage;
  #cancel: (() => void) | undefined;

  constructor(editor: GraphEditor, stage: CanvasStage) {
    this.#editor = editor;
    this.#stage = stage;
  }

  /** Handles a pointer that goes down on a handle. */
  press(start: PointerEvent, { id, kind }: FrameNode | CommentNode, handle: Handle): void {
    this.#cancel?.();
    const [before] = this.#stage.boxes([id]);
    if (before === undefined) return;
    const { x, y, width, height } = before;
    const grip = this.#stage.toCanvas(start.clientX, start.clientY);
    this.#editor.select([id]);
    this.#stage.hold(new Set([id]));
    this.#cancel = followPointer(start, {
      move: (event) => {
        if (this.shown.value === undefined && isClick(start, event)) return;
        const to = this.#stage.toCanvas(event.clientX, event.clientY);
        const way = { x: snap(to.x - grip.x), y: snap(to.y - grip.y) };
        const box = resizeBox(kind, { x, y, width, height }, handle, way);
        this.shown.value = { id, box };
        this.#stage.put([[id, { x: box.x, y: box.y }]]);
      },
      drop: () => {
        this.#apply();
        this.#end();
      },
      cancel: () => {
        this.#stage.put([[id, { x, y }]]);
        this.#end();
      },
    });
  }

  cancel(): void {
    this.#cancel?.();
  }

  /** Handles a changed graph: releases a removed node. */
  handleGraph(): void {
    const id = this.shown.value?.id;
    if (id !== undefined && !this.#editor.graph.value.nodes.has(id)) this.cancel();
  }

  #apply(): void {
    const { id, box } = this.shown.value ?? {};
    const graph = this.#editor.graph.value;
    const node = id === undefined ? undefined : graph.nodes.get(id);
    if (box === undefined || node === undefined) return;
    const { x, y, width, height } = box;
    this.#editor.apply(
      node.kind === 'frame'
        ? resizeFrame(graph, node, box, this.#stage.boxes())
        : { kind: 'resize', node: node.id, size: { width, height }, position: { x, y } },
    );
  }

  #end(): void {
    this.#cancel = undefined;
    this.shown.value = undefined;
    this.#stage.hold(new Set());
    void this.#stage.show(this.#editor.places.value);
  }
}
