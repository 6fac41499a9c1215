// @vitest-environment happy-dom
import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { viewerById, viewerOf, viewersOf, VIEWERS } from './viewers.ts';

const FORMATS = Object.keys(DATA_FORMATS) as DataFormat[];

describe('viewersOf', () => {
  it.each([
    ['double', ['plot', 'json', 'bytes']],
    ['vector3', ['plot', 'space', 'json', 'bytes']],
    ['vector3List', ['space', 'table', 'json', 'bytes']],
    ['quaternion', ['space', 'plot', 'json', 'bytes']],
    ['matrix4x4', ['space', 'table', 'json', 'bytes']],
    ['pose3D', ['space', 'plot', 'json', 'bytes']],
    ['object3DList', ['space', 'table', 'json', 'bytes']],
    ['object2DList', ['plane', 'table', 'json', 'bytes']],
    ['vector2', ['plot', 'plane', 'json', 'bytes']],
    ['bool', ['plot', 'events', 'json', 'bytes']],
    ['keyEvent', ['events', 'json', 'bytes']],
    ['touchEventList', ['events', 'table', 'json', 'bytes']],
    ['image2D', ['picture', 'json', 'bytes']],
    ['stringList', ['table', 'json', 'bytes']],
    ['client', ['json', 'bytes']],
  ] as const)('offers for %s what fits, the best first', (format, ids) => {
    const ours = viewersOf(format)
      .map(({ id }) => id)
      .filter((id) => (ids as readonly string[]).includes(id));
    expect(ours).toEqual(ids);
    expect(viewerOf(format).id).toBe(ids[0]);
  });

  it('has one for every format, and finds each by its id', () => {
    for (const format of FORMATS) expect(viewersOf(format).length, format).toBeGreaterThan(0);
    for (const viewer of VIEWERS) expect(viewerById(viewer.id)).toBe(viewer);
    expect(viewerById('of a later version')).toBeUndefined();
  });
});
