import { DATA_FORMATS, type DataFormat, type TopicRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { isInPixels, PLANE_FORMATS, planeShapes, planeView, steadyView } from './plane-shapes.ts';

const record = (format: DataFormat, value: unknown): TopicRecord =>
  ({ topic: '/a', clientId: '', timestampMs: 0, format, value }) as TopicRecord;

it.each([...PLANE_FORMATS] as DataFormat[])('%s has a place in the plane', (format) => {
  const found = planeShapes(record(format, DATA_FORMATS[format].createDefault()));
  expect(found?.shapes).toHaveLength(found?.count ?? -1);
});

it('others have none', () => {
  expect(planeShapes(record('double', 1))).toBeUndefined();
});

it('a thing with a size is a box from its top left corner, one without is a point', () => {
  const pose = { position: { x: 0.25, y: 0.5 }, angle: 0 };
  const found = planeShapes(
    record('object2DList', {
      elements: [
        { id: 'cup', pose, size: { x: 0.2, y: 0.1 } },
        { id: 'dot', pose },
      ],
    }),
  );
  expect(found?.shapes[0]).toEqual({
    key: '0',
    name: 'cup',
    x: 0.25,
    y: 0.5,
    size: { width: 0.2, height: 0.1 },
  });
  expect(found?.shapes[1]?.size).toBeUndefined();
});

it('shows a surface from 0 to 1, and what reaches further around 0', () => {
  const near = planeShapes(record('touchEvent', { type: 0, position: { x: 0.5, y: 1 }, id: '1' }))!;
  expect(planeView(near.shapes).isSurface).toBe(true);
  const far = planeShapes(record('vector2', { x: 30, y: -4 }))!;
  expect(planeView(far.shapes)).toMatchObject({ left: -50, width: 100 });
  expect(isInPixels(far.shapes)).toBe(true);
  expect(isInPixels(near.shapes)).toBe(false);
});

it('a vector from 0 to 1 is a place on a surface, until it has left it', () => {
  const viewOf = (x: number) => planeView(planeShapes(record('vector2', { x, y: 0.5 }))!.shapes);
  expect(steadyView('vector2', viewOf(0.8), undefined).isSurface).toBe(true);
  const left = viewOf(-3);
  expect(steadyView('vector2', viewOf(0.8), left)).toBe(left);
  expect(steadyView('touchEvent', viewOf(0.8), left).isSurface).toBe(true);
});
