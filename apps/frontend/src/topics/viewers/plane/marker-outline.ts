type Pair = readonly [x: number, y: number];

/** The sides of a marker and its axes, as `marker-tracking` writes them into `userDataJson`. */
export interface MarkerOutline {
  readonly corners: readonly Pair[];
  /** Centre, then the ends of x, y and z; empty when there are none. */
  readonly axes: readonly Pair[];
}

/** Longer texts hold something else. */
const MAX_DATA_LENGTH = 400;

/** The outline in the data of an object; undefined when there is none. */
export function outlineIn(json = ''): MarkerOutline | undefined {
  if (json.length > MAX_DATA_LENGTH || !json.includes('"corners"')) return undefined;
  try {
    const { corners, axes } = (JSON.parse(json) ?? {}) as { corners?: unknown; axes?: unknown };
    if (!isPairs(corners) || corners.length < 3) return undefined;
    return { corners, axes: isPairs(axes) && axes.length === 4 ? axes : [] };
  } catch {
    return undefined; // data of another program
  }
}

const isPairs = (value: unknown): value is Pair[] =>
  Array.isArray(value) &&
  value.every(
    (pair) =>
      Array.isArray(pair) && pair.length === 2 && pair.every((part) => Number.isFinite(part)),
  );
