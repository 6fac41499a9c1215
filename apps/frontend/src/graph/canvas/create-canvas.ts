import { shallowRef, type Ref } from 'vue';
import type { GraphEditor } from '../editing/graph-editor.ts';
import { drawnSize, drawnSizeIn, drawnSocket } from '../nodes/drawn-size.ts';
import { nodeMeasures } from '../nodes/node-geometry.ts';
import { CanvasCommands } from './canvas-commands.ts';
import { CanvasStage } from './canvas-stage.ts';
import { ConnectGesture } from './connect-gesture.ts';
import { InsertTarget } from './drag/insert-target.ts';
import { NodeDrag } from './drag/node-drag.ts';
import { NodeResize } from './frames/node-resize.ts';
import { KeyWalk } from './keys/key-walk.ts';
import { WirePoints } from './points/wire-points.ts';
import type { Box } from './stage-view.ts';
import type { CanvasContext } from './useCanvas.ts';

/** A canvas that is not in the page yet, and what its views share. */
export interface Canvas {
  readonly container: HTMLElement;
  readonly context: CanvasContext;
}

/** @param modules what is offered where a wire ends */
export function createCanvas(
  editor: GraphEditor,
  modules: ConstructorParameters<typeof ConnectGesture>[2],
  isFresh: Readonly<Ref<boolean>> = shallowRef(false),
): Canvas {
  const container = document.createElement('div');
  container.className = 'graph-stage';
  for (const [name, value] of nodeMeasures()) container.style.setProperty(name, value);
  const stage = new CanvasStage(container);
  stage.socketLater = ({ node: id, port }) => {
    const node = editor.graph.value.nodes.get(id);
    return node && drawnSocket(node, port, stage.sizes.get(id) ?? drawnSize(node));
  };
  const target = new InsertTarget(stage);
  const points = new WirePoints(editor, stage);
  const context = {
    stage,
    target,
    points,
    isFresh,
    gesture: new ConnectGesture(editor, stage, modules),
    drag: new NodeDrag(editor, stage, target),
    resize: new NodeResize(editor, stage),
    commands: new CanvasCommands(editor, stage, points),
    walk: new KeyWalk(editor, stage),
  };
  return { container, context };
}

/** Estimated boxes of all nodes before they are drawn. */
export function placeBoxes(editor: GraphEditor): Box[] {
  const sizeOf = drawnSizeIn(editor.graph.value);
  return [...editor.places.value].flatMap(([id, place]) => {
    const node = editor.graph.value.nodes.get(id);
    return node === undefined ? [] : [{ ...place, ...sizeOf(node) }];
  });
}
