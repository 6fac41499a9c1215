import type { GraphCommand } from '../../model/commands/graph-command.ts';
import type { Point, PortRef } from '../../model/graph.ts';

/** What a menu is about. */
export type MenuTarget =
  | { readonly kind: 'nodes'; readonly nodes: readonly string[] }
  | { readonly kind: 'wire'; readonly wire: string }
  | { readonly kind: 'socket'; readonly port: PortRef }
  | { readonly kind: 'canvas' };

/** What happens beside the graph when an entry is chosen. */
export type MenuRequest =
  | { readonly kind: 'inspect'; readonly node: string }
  | { readonly kind: 'copy' | 'cut'; readonly nodes: readonly string[] }
  | { readonly kind: 'select'; readonly nodes: readonly string[] }
  | { readonly kind: 'selectMore' }
  | { readonly kind: 'open module' | 'open topic'; readonly name: string }
  | { readonly kind: 'add'; readonly at: Point; readonly end?: PortRef; readonly wire?: string }
  | { readonly kind: 'paste'; readonly at: Point }
  | { readonly kind: 'arrange' | 'fit' | 'find' };

/** What an entry does: a step that can be undone, a request, or the one after the other. */
export interface MenuDeed {
  readonly command?: GraphCommand;
  /** What is selected after the command. */
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
  /** Keys that do the same: `Ctrl D`. */
  readonly shortcut?: string;
  readonly isDanger?: boolean;
}

/** What entries need to know besides the graph. */
export interface MenuPlace {
  /** Where the menu was asked for, on the canvas. */
  readonly at: Point;
  /** How large and where a node is drawn. */
  boxOf(node: string): (Point & { readonly width: number; readonly height: number }) | undefined;
  /** Where a wire is nearest to the place, and which of its points comes after that. */
  spotOn(wire: string): (Point & { readonly leg: number }) | undefined;
  /** Gives a new UUID. */
  uuid(): string;
  /** Asked for with a finger or a pen. */
  readonly isTouch: boolean;
}

export const SEPARATOR: MenuEntry = { kind: 'separator' };

export const action = (
  text: string,
  deed: MenuDeed,
  look: { readonly shortcut?: string; readonly isDanger?: boolean } = {},
): MenuAction => ({ kind: 'action', text, ...deed, ...look });

/** Groups of lines with separators between those that are not empty. */
export function separated(...groups: readonly (readonly MenuEntry[])[]): MenuEntry[] {
  return groups
    .filter((group) => group.length > 0)
    .flatMap((group, index) => (index === 0 ? group : [SEPARATOR, ...group]));
}
