import { isSplit, type LayoutNode, type Side } from './layout.ts';

/** Part of the page, as shares of its width and height. */
export interface Rect {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

/** Line between two parts. */
export interface Divider extends Rect {
  /** Path of its split, for `setShare`. */
  readonly path: string;
  readonly direction: 'row' | 'column';
  readonly share: number;
  /** The panel before it, from which its name is derived. */
  readonly before: string;
  /** Area of both parts. */
  readonly whole: Rect;
}

const WHOLE: Rect = { left: 0, top: 0, width: 1, height: 1 };

/** Returns the areas of all panels and dividers. */
export function layoutRects(root: LayoutNode | undefined): {
  readonly panels: ReadonlyMap<string, Rect>;
  readonly dividers: readonly Divider[];
} {
  const panels = new Map<string, Rect>();
  const dividers: Divider[] = [];
  const visit = (node: LayoutNode, rect: Rect, path: string): void => {
    if (!isSplit(node)) {
      panels.set(node.id, rect);
      return;
    }
    const { direction, share } = node;
    const { left, top, width, height } = rect;
    const isRow = direction === 'row';
    const first = isRow ? { ...rect, width: width * share } : { ...rect, height: height * share };
    const second = isRow
      ? { ...rect, left: left + first.width, width: width - first.width }
      : { ...rect, top: top + first.height, height: height - first.height };
    dividers.push({
      path,
      direction,
      share,
      before: firstPanel(node.second),
      whole: rect,
      left: second.left,
      top: second.top,
      width: isRow ? 0 : width,
      height: isRow ? height : 0,
    });
    visit(node.first, first, `${path}0`);
    visit(node.second, second, `${path}1`);
  };
  if (root) visit(root, WHOLE, '');
  return { panels, dividers };
}

const firstPanel = (node: LayoutNode): string => (isSplit(node) ? firstPanel(node.first) : node.id);

/** Returns the position for a new panel: beside the largest one, along its longer side. */
export function roomiest(
  root: LayoutNode,
  aspect: number,
): { readonly id: string; readonly side: 'right' | 'bottom' } {
  let best: { id: string; rect: Rect } | undefined;
  for (const [id, rect] of layoutRects(root).panels) {
    const area = rect.width * rect.height;
    if (!best || area > best.rect.width * best.rect.height + 1e-9) best = { id, rect };
  }
  const { id, rect } = best!;
  return { id, side: rect.width * aspect >= rect.height ? 'right' : 'bottom' };
}

/** Returns the adjacent panel in a direction: the one that shares most of the edge. */
export function neighbourOf(
  root: LayoutNode | undefined,
  id: string,
  side: Exclude<Side, 'middle'>,
): string | undefined {
  const { panels } = layoutRects(root);
  const from = panels.get(id);
  if (!from) return undefined;
  const isNear = (a: number, b: number): boolean => Math.abs(a - b) < 1e-6;
  let best: { id: string; overlap: number } | undefined;
  for (const [other, rect] of panels) {
    const touches = {
      left: isNear(rect.left + rect.width, from.left),
      right: isNear(rect.left, from.left + from.width),
      top: isNear(rect.top + rect.height, from.top),
      bottom: isNear(rect.top, from.top + from.height),
    }[side];
    if (!touches || other === id) continue;
    const overlap =
      side === 'left' || side === 'right'
        ? overlapOf(rect.top, rect.height, from.top, from.height)
        : overlapOf(rect.left, rect.width, from.left, from.width);
    if (overlap > 1e-6 && (!best || overlap > best.overlap + 1e-6)) best = { id: other, overlap };
  }
  return best?.id;
}

const overlapOf = (a: number, aSize: number, b: number, bSize: number): number =>
  Math.min(a + aSize, b + bSize) - Math.max(a, b);

/** Returns the side of a panel under the pointer; the middle swaps panels. @param x and `y` shares of the panel */
export function sideAt(x: number, y: number): Side {
  const edge = 0.3;
  const distances: readonly (readonly [Side, number])[] = [
    ['left', x],
    ['right', 1 - x],
    ['top', y],
    ['bottom', 1 - y],
  ];
  const [side, distance] = distances.reduce((best, one) => (one[1] < best[1] ? one : best));
  return distance < edge ? side : 'middle';
}
