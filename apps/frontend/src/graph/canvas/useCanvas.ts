import type { InjectionKey, Ref } from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import type { CanvasCommands } from './canvas-commands.ts';
import type { CanvasStage } from './canvas-stage.ts';
import type { ConnectGesture } from './connect-gesture.ts';
import type { InsertTarget } from './drag/insert-target.ts';
import type { NodeDrag } from './drag/node-drag.ts';
import type { NodeResize } from './frames/node-resize.ts';
import type { KeyWalk } from './keys/key-walk.ts';
import type { WirePoints } from './points/wire-points.ts';

/** State shared by the views on the canvas. */
export interface CanvasContext {
  readonly stage: CanvasStage;
  readonly gesture: ConnectGesture;
  readonly drag: NodeDrag;
  readonly target: InsertTarget;
  readonly points: WirePoints;
  readonly resize: NodeResize;
  /** Commands of menus and keys on the selection. */
  readonly commands: CanvasCommands;
  /** Keyboard focus on the canvas, and navigation by arrow keys. */
  readonly walk: KeyWalk;
  /** True for some time after the session was started. */
  readonly isFresh: Readonly<Ref<boolean>>;
}

export const CANVAS_CONTEXT: InjectionKey<CanvasContext> = Symbol('canvas');

export function useCanvas(): CanvasContext {
  return injectOrThrow(CANVAS_CONTEXT, 'the canvas above it');
}
