// @vitest-environment happy-dom
import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { offeredViews, viewerById, viewerOf, viewersOf, VIEWERS } from './viewers.ts';

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

describe('the views of a panel', () => {
  const titles = (format: DataFormat | undefined, chosen: string) =>
    offeredViews(format, chosen).map(({ title, isShown }) => (isShown ? `[${title}]` : title));

  it('are those that fit, the best first, which is shown until another is chosen', () => {
    const known = new Set(['[Plot]', 'Plot', '[JSON]', 'JSON', 'Bytes', 'Value', 'Records']);
    const ours = (chosen: string) => titles('double', chosen).filter((title) => known.has(title));
    expect(ours('')).toEqual(['[Plot]', 'JSON', 'Bytes', 'Value', 'Records']);
    expect(ours('json')).toEqual(['Plot', '[JSON]', 'Bytes', 'Value', 'Records']);
    expect(titles('double', '')).not.toContain('Picture');
    expect(titles('double', 'plot')[0]).toBe('[Plot]');
    expect(offeredViews('double', 'json')[0]?.viewer).toBe('');
  });

  it('keep one that was chosen for another format, and are all while the format is unknown', () => {
    expect(titles('double', 'picture')).toContain('[Picture]');
    expect(titles(undefined, '')).toHaveLength(VIEWERS.length);
  });
});
