import { expect, it } from 'vitest';
import { outlineIn } from './marker-outline.ts';
import { planeShapes } from './plane-shapes.ts';

const corners = [
  [0.1, 0.1],
  [0.3, 0.12],
  [0.28, 0.3],
  [0.09, 0.29],
];
const axes = [
  [0.2, 0.2],
  [0.3, 0.2],
  [0.2, 0.1],
  [0.22, 0.22],
];

it('reads the corners and axes that marker-tracking writes', () => {
  expect(outlineIn(JSON.stringify({ corners, axes }))).toEqual({ corners, axes });
  expect(outlineIn(JSON.stringify({ corners }))).toEqual({ corners, axes: [] });
});

it.each([
  ['nothing', undefined],
  ['a score', '{"score":0.9}'],
  ['corners that are no places', '{"corners":[[1],[2],[3]]}'],
  ['corners that are not finite', '{"corners":[[0,0],[1,null],[1,1]]}'],
  ['text that is no JSON', '{"corners":['],
  ['more than an outline', JSON.stringify({ corners, more: 'x'.repeat(400) })],
])('takes %s for no outline', (_what, json) => {
  expect(outlineIn(json)).toBeUndefined();
});

it('is part of a shape, beside its box', () => {
  const element = {
    id: 'aruco_4x4_50:7',
    pose: { position: { x: 0.09, y: 0.1 } },
    size: { x: 0.21, y: 0.2 },
    userDataJson: JSON.stringify({ corners, axes }),
  };
  const record = { topic: '/a', clientId: '', timestampMs: 0, format: 'object2DList' };
  const found = planeShapes({ ...record, value: { elements: [element] } } as never);
  expect(found?.shapes[0]).toMatchObject({ size: { width: 0.21 }, outline: { corners, axes } });
});
