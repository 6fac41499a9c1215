import type { GraphCommand } from '../../model/commands/graph-command.ts';
import type { Point, PortRef } from '../../model/graph.ts';

/** Target of a context menu. */
export type MenuTarget =
  | { readonly kind: 'nodes'; readonly nodes: readonly string[] }
  | { readonly kind: 'wire'; readonly wire: string }
  | { readonly kind: 'socket'; readonly port: PortRef }
  | { readonly kind: 'canvas' };

/** Effect of an entry besides a change of the graph. */
export type MenuRequest =
  | { readonly kind: 'inspect'; readonly node: string }
  | { readonly kind: 'copy' | 'cut'; readonly nodes: readonly string[] }
  | { readonly kind: 'select'; readonly nodes: readonly string[] }
  | { readonly kind: 'selectMore' }
  | { readonly kind: 'open module' | 'open topic'; readonly name: string }
  | { readonly kind: 'add'; readonly at: Point; readonly end?: PortRef; readonly wire?: string }
  | { readonly kind: 'paste'; readonly at: Point }
  | { readonly kind: 'arrange' | 'fit' | 'find' };

/** Effect of an entry: an undoable command, a request, or the command followed by the request. */
export interface MenuDeed {
  readonly command?: GraphCommand;
  /** Ids of nodes to select after the command. */
  readonly select?: readonly string[];
  readonly request?: MenuRequest;
}

/** A line of a menu. */
export type MenuEntry =
  | { readonly kind: 'separator' }
  | { readonly kind: 'group'; readonly text: string; readonly entries: readonly MenuAction[] }
  | MenuAction;

export interface MenuAction extends MenuDeed {
  readonly kind: 'action';
  readonly text: string;
  /** Keyboard shortcut: `Ctrl D`. */
  readonly shortcut?: string;
  readonly isDanger?: boolean;
}

/** Context that entries need besides the graph. */
export interface MenuPlace {
  /** Position of the menu on the canvas. */
  readonly at: Point;
  /** Returns the drawn box of a node. */
  boxOf(node: string): (Point & { readonly width: number; readonly height: number }) | undefined;
  /** Returns the place on a wire nearest to the menu, and the index of the bend point after it. */
  spotOn(wire: string): (Point & { readonly leg: number }) | undefined;
  /** Returns a new UUID. */
  uuid(): string;
  /** True when opened with a finger or a pen. */
  readonly isTouch: boolean;
}

export const SEPARATOR: MenuEntry = { kind: 'separator' };

export const action = (
  text: string,
  deed: MenuDeed,
  look: { readonly shortcut?: string; readonly isDanger?: boolean } = {},
): MenuAction => ({ kind: 'action', text, ...deed, ...look });

/** Joins groups of entries, with separators between those that are not empty. */
export function separated(...groups: readonly (readonly MenuEntry[])[]): MenuEntry[] {
  return groups
    .filter((group) => group.length > 0)
    .flatMap((group, index) => (index === 0 ? group : [SEPARATOR, ...group]));
}
