/** Rectangle on the screen, in any unit. */
export interface Area {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A label and the shape it belongs to. */
export interface LabelWish {
  readonly key: string;
  /** Box of the shape; width and height are 0 for a point. */
  readonly box: Area;
  readonly width: number;
  readonly height: number;
}

/** Position of a label: outside or inside its box, and the corner. */
export type LabelSpot =
  | 'above left'
  | 'inside bottom left'
  | 'inside bottom right'
  | 'above right'
  | 'below left'
  | 'inside top left';

export interface PlacedLabel extends Area {
  readonly key: string;
  readonly spot: LabelSpot;
}

/** Candidate positions, best first. */
const SPOTS: readonly LabelSpot[] = [
  'above left',
  'inside bottom left',
  'inside bottom right',
  'above right',
  'below left',
  'inside top left',
];

/**
 * Places labels without overlaps: outside at the top left of their boxes, or at the next free position. Earlier labels
 * take precedence. If no position is free, the one with the smallest overlap is used.
 *
 * @param view visible part; labels stay in it
 * @param gap between a label and its box, or another label
 * @param before previous positions: a label leaves its position only when necessary
 */
export function placeLabels(
  wishes: readonly LabelWish[],
  view: Area,
  gap: number,
  before: ReadonlyMap<string, LabelSpot> = new Map(),
): PlacedLabel[] {
  const placed: PlacedLabel[] = [];
  for (const wish of wishes) {
    let best: PlacedLabel | undefined;
    let least = Infinity;
    for (const spot of SPOTS) {
      const label = { key: wish.key, spot, ...within(areaOf(wish, spot, gap), view) };
      // Another position needs a free margin; otherwise labels alternate between two positions.
      const margin = before.get(wish.key) === spot ? 0 : gap;
      const covered =
        placed.reduce((sum, other) => sum + sharedOf(grown(label, margin), other), 0) +
        outsideOf(areaOf(wish, spot, gap), view);
      if (covered < least) {
        best = label;
        least = covered;
      }
      if (covered === 0) break;
    }
    placed.push(best!);
  }
  return placed;
}

function areaOf({ box, width, height }: LabelWish, spot: LabelSpot, gap: number): Area {
  const right = box.x + box.width - width;
  const bottom = box.y + box.height;
  switch (spot) {
    case 'above left':
      return { x: box.x, y: box.y - gap - height, width, height };
    case 'above right':
      return { x: right, y: box.y - gap - height, width, height };
    case 'below left':
      return { x: box.x, y: bottom + gap, width, height };
    case 'inside top left':
      return { x: box.x + gap, y: box.y + gap, width, height };
    case 'inside bottom left':
      return { x: box.x + gap, y: bottom - gap - height, width, height };
    case 'inside bottom right':
      return { x: right - gap, y: bottom - gap - height, width, height };
  }
}

/** Moves a rectangle into the view. */
function within(area: Area, view: Area): Area {
  const { width, height } = area;
  const clamp = (value: number, low: number, high: number): number =>
    Math.max(low, Math.min(value, high));
  return {
    x: clamp(area.x, view.x, view.x + view.width - width),
    y: clamp(area.y, view.y, view.y + view.height - height),
    width,
    height,
  };
}

/** Area of a label that is cut off above or below the view. */
function outsideOf({ y, width, height }: Area, view: Area): number {
  const above = Math.max(0, view.y - y);
  const below = Math.max(0, y + height - (view.y + view.height));
  return (above + below) * width;
}

const grown = ({ x, y, width, height }: Area, by: number): Area => ({
  x: x - by,
  y: y - by,
  width: width + 2 * by,
  height: height + 2 * by,
});

function sharedOf(a: Area, b: Area): number {
  const width = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const height = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0;
}
