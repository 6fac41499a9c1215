import { outlineIn, type MarkerOutline } from './marker-outline.ts';
import {
  TouchEventType,
  type Object2D,
  type Pose2D,
  type TopicRecord,
  type TouchEventMessage,
  type Vector2,
} from '@ubii/proto';

/** Object in the plane or on a picture. */
export interface PlaneShape {
  /** Unique among the shapes of one value. */
  readonly key: string;
  readonly name: string;
  /** Top left corner of a box, or position of a point. */
  readonly x: number;
  readonly y: number;
  /** Undefined for a point. */
  readonly size?: { readonly width: number; readonly height: number };
  /** Orientation, radians from the x axis towards the y axis; undefined without one. */
  readonly angle?: number;
  /** Confidence of the detector, 0 to 1; undefined without one. */
  readonly score?: number;
  /** Corners of a rotated shape, and the ends of its axes; in units of x and y. */
  readonly outline?: MarkerOutline;
  /** Drawn hollow: a finger that was lifted. */
  readonly isGone?: boolean;
  /** Distinguishes visible shapes of the same name: `A`. */
  readonly letter?: string;
  /** 0 to 1, below 1 while it fades out. @default 1 */
  readonly opacity?: number;
}

/** Most shapes drawn; the total number is shown. */
export const MAX_SHAPES = 500;

/** Converts a value to shapes; `undefined` for formats without positions in the plane. */
export function planeShapes(
  record: TopicRecord,
): { readonly shapes: readonly PlaneShape[]; readonly count: number } | undefined {
  const { format, value } = record;
  switch (format) {
    case 'vector2':
      return one(point('0', '', value));
    case 'vector2List':
      return many(value.elements, (element, key) => point(key, '', element));
    case 'pose2D':
      return one(posed('0', '', value));
    case 'object2D':
      return one(object(value, '0'));
    case 'object2DList':
      return many(value.elements, object);
    case 'touchEvent':
      return one(touch(value, '0'));
    case 'touchEventList':
      return many(value.elements, touch);
    default:
      return undefined;
  }
}

/** Data formats with positions in the plane. */
export const PLANE_FORMATS: ReadonlySet<string> = new Set<TopicRecord['format']>([
  'object2DList',
  'object2D',
  'pose2D',
  'vector2List',
  'vector2',
  'touchEventList',
  'touchEvent',
]);

const one = (shape: PlaneShape) => ({ shapes: [shape], count: 1 });

function many<T>(elements: readonly T[], read: (element: T, key: string) => PlaneShape) {
  const shapes = elements
    .slice(0, MAX_SHAPES)
    .map((element, index) => read(element, String(index)));
  return { shapes, count: elements.length };
}

const finite = (value: number | undefined): number => (Number.isFinite(value) ? value! : 0);

const point = (key: string, name: string, at: Vector2 | undefined): PlaneShape => ({
  key,
  name,
  x: finite(at?.x),
  y: finite(at?.y),
});

function posed(key: string, name: string, { position, angle, direction }: Pose2D): PlaneShape {
  const faces = direction ? Math.atan2(direction.y, direction.x) : angle;
  return { ...point(key, name, position), ...(faces === undefined ? {} : { angle: faces }) };
}

function object({ id, pose, size, userDataJson }: Object2D, key: string): PlaneShape {
  const score = scoreIn(userDataJson);
  const outline = outlineIn(userDataJson);
  const place = {
    ...(pose ? posed(key, id, pose) : point(key, id, undefined)),
    ...(score === undefined ? {} : { score }),
    ...(outline === undefined ? {} : { outline }),
  };
  if (!size || !(size.x > 0 || size.y > 0)) return place;
  // Detectors without an angle may omit it or set 0: a box that is not rotated has no arrow.
  const { angle, ...rest } = place;
  return {
    ...rest,
    size: { width: finite(size.x), height: finite(size.y) },
    ...(angle ? { angle } : {}),
  };
}

/** Longest text that is parsed for a score, characters. */
const MAX_DATA_LENGTH = 200;

/** Returns the score that detectors of the module library write: `{ "score": 0.87 }`. */
function scoreIn(json = ''): number | undefined {
  if (json === '' || json.length > MAX_DATA_LENGTH) return undefined;
  try {
    const { score } = (JSON.parse(json) ?? {}) as { score?: unknown };
    return typeof score === 'number' && score >= 0 && score <= 1 ? score : undefined;
  } catch {
    return undefined; // Data of another program.
  }
}

const touch = ({ id, position, type }: TouchEventMessage, key: string): PlaneShape => ({
  ...point(key, id, position),
  isGone: type === TouchEventType.TOUCH_END,
});

/** Visible part of the plane, y down as on pictures or up as in mathematics. */
export interface PlaneView {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /** Surface with coordinates from 0 to 1, y down. */
  readonly isSurface: boolean;
}

/** Formats of positions on a surface, whatever their range. */
const OF_SURFACE = /^(touchEvent|object2D|pose2D)/;

/**
 * Returns a surface when all shapes are within 0 to 1, as positions on screens and pictures are; otherwise a square of
 * round size around 0.
 */
export function planeView(shapes: readonly PlaneShape[]): PlaneView {
  const fits = shapes.every(
    ({ x, y, size }) =>
      x >= -0.05 && y >= -0.05 && x + (size?.width ?? 0) <= 1.05 && y + (size?.height ?? 0) <= 1.05,
  );
  if (fits) return { left: 0, top: 0, width: 1, height: 1, isSurface: true };
  const most = Math.max(
    0,
    ...shapes.flatMap(({ x, y, size }) => [
      Math.abs(x) + (size?.width ?? 0),
      Math.abs(y) + (size?.height ?? 0),
    ]),
  );
  const power = 10 ** Math.floor(Math.log10(most > 0 && Number.isFinite(most) ? most : 1));
  const reach = power * ([1, 2, 5, 10].find((factor) => factor * power >= most) ?? 10);
  return { left: -reach, top: -reach, width: 2 * reach, height: 2 * reach, isSurface: false };
}

/**
 * Returns the visible part for a value that moves.
 * @param least largest part shown before: vectors that once left the surface are not positions on it
 */
export function steadyView(
  format: TopicRecord['format'],
  now: PlaneView,
  least: PlaneView | undefined,
): PlaneView {
  if (least === undefined || least.width <= now.width) return now;
  return now.isSurface && OF_SURFACE.test(format) ? now : least;
}

/** Whether positions on a picture are in pixels, contrary to the schema: some are far beyond 1. */
export function isInPixels(shapes: readonly PlaneShape[]): boolean {
  return shapes.some(({ x, y, size }) =>
    [x, y, size?.width ?? 0, size?.height ?? 0].some((part) => Math.abs(part) > 2),
  );
}
