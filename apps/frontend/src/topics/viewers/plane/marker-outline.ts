type Pair = readonly [x: number, y: number];

/** Outline and axes of a marker, as `marker-tracking` writes them to `userDataJson`. */
export interface MarkerOutline {
  readonly corners: readonly Pair[];
  /** Centre, then the ends of x, y and z; may be empty. */
  readonly axes: readonly Pair[];
}

/** Longest text that is parsed, characters. */
const MAX_DATA_LENGTH = 400;

/** Returns the outline in the data of an object; undefined without one. */
export function outlineIn(json = ''): MarkerOutline | undefined {
  if (json.length > MAX_DATA_LENGTH || !json.includes('"corners"')) return undefined;
  try {
    const { corners, axes } = (JSON.parse(json) ?? {}) as { corners?: unknown; axes?: unknown };
    if (!isPairs(corners) || corners.length < 3) return undefined;
    return { corners, axes: isPairs(axes) && axes.length === 4 ? axes : [] };
  } catch {
    return undefined; // Data of another program.
  }
}

const isPairs = (value: unknown): value is Pair[] =>
  Array.isArray(value) &&
  value.every(
    (pair) =>
      Array.isArray(pair) && pair.length === 2 && pair.every((part) => Number.isFinite(part)),
  );
