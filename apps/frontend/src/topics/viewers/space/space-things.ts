import type {
  DataFormat,
  DataFormatValues,
  Matrix3x2,
  Matrix4x4,
  Object3D,
  Pose3D,
  Quaternion,
  Vector3,
} from '@ubii/proto';
import { normalized, rotate } from '../../../message-form/rotation.ts';

export type Point = readonly [number, number, number];
/** Images of the unit vectors x, y, z under the rotation. */
export type Axes = readonly [Point, Point, Point];

/** Object to draw, in the coordinates of the publisher. */
export interface SpaceThing {
  /** Unique among the objects of one value. */
  readonly key: string;
  /** Display name; may be empty. */
  readonly name: string;
  readonly at: Point;
  /** Undefined without a rotation. */
  readonly axes?: Axes;
  /** Size along its own axes; undefined without one. */
  readonly size?: Point;
  /** Arrow from the origin for a single vector, dot for one of several. */
  readonly mark: 'arrow' | 'dot' | 'axes';
  /** Axes are drawn in their actual length, because it is significant. */
  readonly isToScale: boolean;
}

/** Objects of a value, and a note about the interpretation where the format is ambiguous. */
export interface SpaceView {
  readonly things: readonly SpaceThing[];
  /** Number of objects in the value. */
  readonly count: number;
  readonly note: string | undefined;
}

/** Most objects drawn; the total number is shown. */
export const MAX_THINGS = 300;

export const ORIGIN: Point = [0, 0, 0];
const UNIT: Axes = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const FULL_TURN = 2 * Math.PI;
const RADIANS = Math.PI / 180;

type Reader<F extends DataFormat> = (value: DataFormatValues[F]) => SpaceView;

const one = (thing: Omit<SpaceThing, 'key' | 'name'> & { name?: string }, note?: string) => ({
  things: [{ key: '0', name: '', ...thing }],
  count: 1,
  note,
});

const point = (vector: Vector3 | undefined): Point =>
  vector ? [finite(vector.x), finite(vector.y), finite(vector.z)] : ORIGIN;
const finite = (value: number): number => (Number.isFinite(value) ? value : 0);

export function axesOf(quaternion: Quaternion): Axes {
  const unit = normalized(quaternion);
  return UNIT.map((axis) => rotate(unit, axis)) as unknown as Axes;
}

const rotation = (value: Quaternion): SpaceView =>
  one(
    { at: ORIGIN, axes: axesOf(value), mark: 'axes', isToScale: true },
    value.x === 0 && value.y === 0 && value.z === 0 && value.w === 0
      ? 'All four numbers are 0, which is not a valid rotation. It is drawn without rotation.'
      : undefined,
  );

/** Radians, unless a number exceeds a full turn. */
function eulerAxes({ x, y, z }: Vector3): { axes: Axes; note: string } {
  const isDegrees = [x, y, z].some((angle) => Math.abs(angle) > FULL_TURN);
  const unit = isDegrees ? RADIANS : 1;
  const half = [x, y, z].map((angle) => (finite(angle) * unit) / 2);
  const about = (index: number) => ({
    x: index === 0 ? Math.sin(half[0]!) : 0,
    y: index === 1 ? Math.sin(half[1]!) : 0,
    z: index === 2 ? Math.sin(half[2]!) : 0,
    w: Math.cos(half[index]!),
  });
  // Rotations about x first, then y, then z, in fixed axes.
  const axes = UNIT.map((axis) =>
    rotate(about(2), rotate(about(1), rotate(about(0), axis))),
  ) as unknown as Axes;
  return {
    axes,
    note: `Euler angles are read as ${isDegrees ? 'degrees' : 'radians'}, about x, then y, then z.`,
  };
}

function pose({ position, quaternion, euler }: Pose3D) {
  const turned = euler ? eulerAxes(euler) : { axes: quaternion && axesOf(quaternion) };
  const at = point(position);
  return {
    thing: { at, mark: 'axes' as const, axes: turned.axes ?? UNIT, isToScale: false },
    note: 'note' in turned ? turned.note : undefined,
  };
}

function objects(elements: readonly Object3D[]): SpaceView {
  const notes = new Set<string>();
  const seen = new Map<string, number>();
  const things = elements.slice(0, MAX_THINGS).map(({ id, pose: where, size }): SpaceThing => {
    const { thing, note } = pose(where ?? ({} as Pose3D));
    if (note) notes.add(note);
    const times = (seen.get(id) ?? 0) + 1;
    seen.set(id, times);
    const key = `${id}#${times}`;
    const hasSize = size !== undefined && [size.x, size.y, size.z].some((part) => part > 0);
    return { key, name: id, ...thing, ...(hasSize ? { size: point(size) } : {}) };
  });
  return { things, count: elements.length, note: [...notes][0] };
}

/**
 * Converts a matrix to the images of the unit vectors and the origin. The translation is in the last column, or in the
 * last row if only that is not zero.
 */
function matrix(m: Matrix4x4): SpaceView {
  const isRows =
    [m.m03, m.m13, m.m23].every((part) => part === 0) &&
    [m.m30, m.m31, m.m32].some((part) => part !== 0);
  const axes: Axes = isRows
    ? [
        [m.m00, m.m01, m.m02],
        [m.m10, m.m11, m.m12],
        [m.m20, m.m21, m.m22],
      ]
    : [
        [m.m00, m.m10, m.m20],
        [m.m01, m.m11, m.m21],
        [m.m02, m.m12, m.m22],
      ];
  const at: Point = isRows ? [m.m30, m.m31, m.m32] : [m.m03, m.m13, m.m23];
  const note = isRows
    ? 'Rows are read as the images of the axes: the last row is the translation.'
    : 'Columns are read as the images of the axes, the last column as the translation.';
  return one({ at, axes, mark: 'axes', isToScale: true }, note);
}

const plane = (m: Matrix3x2): SpaceView =>
  one(
    {
      at: [m.m20, m.m21, 0],
      axes: [
        [m.m00, m.m01, 0],
        [m.m10, m.m11, 0],
        [0, 0, 0],
      ],
      mark: 'axes',
      isToScale: true,
    },
    'A transform of the plane, with the axes x and y and the translation.',
  );

const READERS: { readonly [F in DataFormat]?: Reader<F> } = {
  vector3: (value) => one({ at: point(value), mark: 'arrow', isToScale: false }),
  vector3List: ({ elements }) => ({
    things: elements.slice(0, MAX_THINGS).map((element, index) => ({
      key: String(index),
      name: '',
      at: point(element),
      mark: 'dot',
      isToScale: false,
    })),
    count: elements.length,
    note: undefined,
  }),
  quaternion: rotation,
  quaternionList: rotation,
  matrix3x2: plane,
  matrix4x4: matrix,
  pose3D: (value) => {
    const { thing, note } = pose(value);
    return one(thing, note);
  },
  object3D: (value) => objects([value]),
  object3DList: ({ elements }) => objects(elements),
};

export function isSpatial(format: DataFormat): boolean {
  return READERS[format] !== undefined;
}

/** Converts a value to objects in space; undefined for formats without positions in space. */
export function spaceView<F extends DataFormat>(format: F, value: DataFormatValues[F]): SpaceView {
  const reader = READERS[format] as Reader<F> | undefined;
  return reader?.(value) ?? { things: [], count: 0, note: undefined };
}
