import type { ViewerSettings } from '../../viewers/topic-viewer.ts';

/** View of a topic. */
export interface Panel {
  /** Unique within the layout. */
  readonly id: string;
  /** Id of a viewer; empty: the best one for the topic's data format. */
  readonly viewer: string;
  readonly topic: string;
  readonly settings: ViewerSettings;
}

/** What a panel shows. */
export type PanelChoice = Omit<Panel, 'id'>;

/** Two parts side by side (`row`) or one above the other (`column`). */
export interface Split {
  readonly direction: 'row' | 'column';
  /** Share of the first part, 0 to 1. */
  readonly share: number;
  readonly first: LayoutNode;
  readonly second: LayoutNode;
}

export type LayoutNode = Panel | Split;

/** Panels and their division of the page. */
export interface Layout {
  readonly name: string;
  /** `undefined` without panels. */
  readonly root: LayoutNode | undefined;
}

/** Position of a panel relative to another; `middle` swaps the two. */
export type Side = 'left' | 'right' | 'top' | 'bottom' | 'middle';

export const MAX_PANELS = 12;
export const MAX_NAME = 80;
export const MIN_SHARE = 0.1;

export const EMPTY_LAYOUT: Layout = { name: '', root: undefined };

export const isSplit = (node: LayoutNode): node is Split => 'direction' in node;

export const clampShare = (share: number): number =>
  Math.min(1 - MIN_SHARE, Math.max(MIN_SHARE, share));

/** In reading order. */
export function panelsOf(root: LayoutNode | undefined): readonly Panel[] {
  if (!root) return [];
  return isSplit(root) ? [...panelsOf(root.first), ...panelsOf(root.second)] : [root];
}

/** Returns an unused number as the id of a new panel. */
export function freeId(root: LayoutNode | undefined): string {
  const taken = new Set(panelsOf(root).map(({ id }) => id));
  let next = taken.size + 1;
  while (taken.has(String(next))) next++;
  return String(next);
}

/** Replaces one panel by the returned node; `undefined` removes it. */
function mapPanel(
  node: LayoutNode,
  id: string,
  make: (panel: Panel) => LayoutNode | undefined,
): LayoutNode | undefined {
  if (!isSplit(node)) return node.id === id ? make(node) : node;
  const first = mapPanel(node.first, id, make);
  const second = mapPanel(node.second, id, make);
  if (first === node.first && second === node.second) return node;
  if (!first || !second) return first ?? second;
  return { ...node, first, second };
}

function beside(there: LayoutNode, added: Panel, side: Exclude<Side, 'middle'>): Split {
  const isBefore = side === 'left' || side === 'top';
  return {
    direction: side === 'left' || side === 'right' ? 'row' : 'column',
    share: 0.5,
    first: isBefore ? added : there,
    second: isBefore ? there : added,
  };
}

export function changePanel(
  root: LayoutNode | undefined,
  id: string,
  changes: Partial<PanelChoice>,
): LayoutNode | undefined {
  return root && mapPanel(root, id, (panel) => ({ ...panel, ...changes }));
}

export function removePanel(root: LayoutNode | undefined, id: string): LayoutNode | undefined {
  return root && mapPanel(root, id, () => undefined);
}

export function insertPanel(
  root: LayoutNode | undefined,
  panel: Panel,
  at: { readonly id: string; readonly side: Exclude<Side, 'middle'> },
): LayoutNode {
  if (!root) return panel;
  return mapPanel(root, at.id, (there) => beside(there, panel, at.side))!;
}

/** Moves a panel beside another one, or swaps the two. */
export function movePanel(
  root: LayoutNode | undefined,
  id: string,
  at: { readonly id: string; readonly side: Side },
): LayoutNode | undefined {
  const panels = panelsOf(root);
  const moved = panels.find((panel) => panel.id === id);
  const target = panels.find((panel) => panel.id === at.id);
  if (!root || !moved || !target || moved === target) return root;
  const { side } = at;
  if (side !== 'middle') {
    return mapPanel(removePanel(root, id)!, at.id, (there) => beside(there, moved, side));
  }
  const swap = (node: LayoutNode): LayoutNode => {
    if (isSplit(node)) return { ...node, first: swap(node.first), second: swap(node.second) };
    return node === moved ? target : node === target ? moved : node;
  };
  return swap(root);
}

/** @param path of the split from the root: `0` for the first part, `1` for the second */
export function setShare(
  root: LayoutNode | undefined,
  path: string,
  share: number,
): LayoutNode | undefined {
  if (!root || !isSplit(root)) return root;
  if (path === '') return { ...root, share: clampShare(share) };
  const [part, rest] = [path[0], path.slice(1)];
  return part === '0'
    ? { ...root, first: setShare(root.first, rest, share)! }
    : { ...root, second: setShare(root.second, rest, share)! };
}
