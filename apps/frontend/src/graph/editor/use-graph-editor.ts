import { inject, type InjectionKey, type Ref } from 'vue';
import type { CanvasCommands } from '../canvas/canvas-commands.ts';
import type { CanvasStage } from '../canvas/canvas-stage.ts';
import type { ConnectGesture } from '../canvas/connect-gesture.ts';
import type { InsertTarget } from '../canvas/drag/insert-target.ts';
import type { NodeDrag } from '../canvas/drag/node-drag.ts';
import type { NodeResize } from '../canvas/frames/node-resize.ts';
import type { KeyWalk } from '../canvas/keys/key-walk.ts';
import type { WirePoints } from '../canvas/points/wire-points.ts';
import type { LiveGraph } from '../live/live-graph.ts';
import type { OwnPad } from '../live/own-pad.ts';
import type { GraphEditor } from './graph-editor.ts';

/** What the parts of the editor share. */
export interface GraphContext {
  readonly editor: GraphEditor;
  readonly live: LiveGraph;
  readonly pad: OwnPad;
}

/** What the views on the canvas share besides. */
export interface CanvasContext {
  readonly stage: CanvasStage;
  readonly gesture: ConnectGesture;
  readonly drag: NodeDrag;
  readonly target: InsertTarget;
  readonly points: WirePoints;
  readonly resize: NodeResize;
  /** Commands of menus and keys on the selection. */
  readonly commands: CanvasCommands;
  /** Where the focus of the keyboard is, and where arrow keys lead. */
  readonly walk: KeyWalk;
  /** It was started just now. */
  readonly isFresh: Readonly<Ref<boolean>>;
}

export const GRAPH_CONTEXT: InjectionKey<GraphContext> = Symbol('graph');
export const CANVAS_CONTEXT: InjectionKey<CanvasContext> = Symbol('canvas');

export function useGraphContext(): GraphContext {
  const context = inject(GRAPH_CONTEXT);
  if (!context) throw new Error('This part needs the graph page above it.');
  return context;
}

export function useCanvas(): CanvasContext {
  const context = inject(CANVAS_CONTEXT);
  if (!context) throw new Error('This part needs the canvas above it.');
  return context;
}
