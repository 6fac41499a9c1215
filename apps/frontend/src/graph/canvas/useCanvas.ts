import { inject, type InjectionKey, type Ref } from 'vue';
import type { CanvasCommands } from './canvas-commands.ts';
import type { CanvasStage } from './canvas-stage.ts';
import type { ConnectGesture } from './connect-gesture.ts';
import type { InsertTarget } from './drag/insert-target.ts';
import type { NodeDrag } from './drag/node-drag.ts';
import type { NodeResize } from './frames/node-resize.ts';
import type { KeyWalk } from './keys/key-walk.ts';
import type { WirePoints } from './points/wire-points.ts';

/** What the views on the canvas share. */
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

export const CANVAS_CONTEXT: InjectionKey<CanvasContext> = Symbol('canvas');

export function useCanvas(): CanvasContext {
  const context = inject(CANVAS_CONTEXT);
  if (!context) throw new Error('This part needs the canvas above it.');
  return context;
}
