import type { DataFormat } from '@ubii/proto';

/** Members of values that are a row of numbers, in the order in which other systems have them. */
export const NUMBER_MEMBERS: Partial<Readonly<Record<DataFormat, readonly string[]>>> = {
  vector2: ['x', 'y'],
  vector3: ['x', 'y', 'z'],
  vector4: ['x', 'y', 'z', 'w'],
  quaternion: ['x', 'y', 'z', 'w'],
  color: ['r', 'g', 'b', 'a'],
};
