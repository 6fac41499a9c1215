import { DATA_FORMATS, type DataFormat, type Object3D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { anglesOf, describeView } from './describe-things.ts';
import { groundFor } from './reach.ts';
import { isSpatial, MAX_THINGS, spaceView, type Axes } from './space-things.ts';

const FORMATS = (Object.keys(DATA_FORMATS) as DataFormat[]).filter(isSpatial);
const HALF = Math.SQRT1_2;
const round = (axes: Axes | undefined) =>
  axes?.map((axis) => axis.map((part) => Number(part.toFixed(6)) + 0));

describe('spaceView', () => {
  it.each(FORMATS)('%s: its neutral value is drawn without a complaint', (format) => {
    const view = spaceView(format, DATA_FORMATS[format].createDefault() as never);
    expect(view.things.length).toBe(view.count);
    for (const { at } of view.things) expect(at).toEqual([0, 0, 0]);
  });

  it('turns the axes as a quaternion says, whatever its length', () => {
    const turned = { x: 0, y: 0, z: HALF, w: HALF };
    for (const factor of [1, 7]) {
      const { x, y, z, w } = turned;
      const value = { x: x * factor, y: y * factor, z: z * factor, w: w * factor };
      const [thing] = spaceView('quaternion', value).things;
      expect(round(thing?.axes)).toEqual([
        [0, 1, 0],
        [-1, 0, 0],
        [0, 0, 1],
      ]);
    }
    expect(spaceView('quaternion', { x: 0, y: 0, z: 0, w: 0 }).note).toMatch(
      /not a valid rotation/,
    );
  });

  it('finds the translation of a matrix in its last column, else in its last row', () => {
    const none = DATA_FORMATS.matrix4x4.createDefault();
    const columns = spaceView('matrix4x4', { ...none, m01: -1, m10: 1, m00: 0, m11: 0, m03: 5 });
    expect(columns.things[0]).toMatchObject({
      at: [5, 0, 0],
      axes: [
        [0, 1, 0],
        [-1, 0, 0],
        [0, 0, 1],
      ],
    });
    const rows = spaceView('matrix4x4', { ...none, m01: 1, m10: -1, m00: 0, m11: 0, m30: 5 });
    expect(rows.things[0]).toMatchObject({
      at: [5, 0, 0],
      axes: [
        [0, 1, 0],
        [-1, 0, 0],
        [0, 0, 1],
      ],
    });
    expect(rows.note).toMatch(/last row/);
  });

  it('reads Euler angles as radians, or as degrees when they are larger than a turn', () => {
    const at = (z: number) => spaceView('pose3D', { euler: { x: 0, y: 0, z } } as never);
    expect(anglesOf(at(Math.PI / 2).things[0]!.axes!).yaw).toBeCloseTo(90);
    expect(anglesOf(at(90).things[0]!.axes!).yaw).toBeCloseTo(90);
    expect(at(90).note).toMatch(/degrees/);
  });

  it('tells things of the same name apart, and draws no more than it can', () => {
    const cup: Object3D = { id: 'cup', userDataJson: '' } as Object3D;
    const two = spaceView('object3DList', { elements: [cup, cup] });
    expect(new Set(two.things.map(({ key }) => key)).size).toBe(2);
    const many = Array.from({ length: MAX_THINGS + 5 }, () => ({ x: 1, y: 2, z: 3 }));
    const view = spaceView('vector3List', { elements: many });
    expect(view.things).toHaveLength(MAX_THINGS);
    expect(view.count).toBe(MAX_THINGS + 5);
    expect(describeView(view)).toMatch(/305 things, the first 300 are drawn/);
  });

  it('draws at the origin what has no number', () => {
    const [thing] = spaceView('vector3', { x: Number.NaN, y: Infinity, z: 1 }).things;
    expect(thing?.at).toEqual([0, 0, 1]);
  });
});

it('the ground is round and holds everything', () => {
  const reachOf = (x: number) => groundFor(spaceView('vector3', { x, y: 0, z: 0 }).things).reach;
  expect([0, 0.03, 1, 3, 7, 12].map(reachOf)).toEqual([1, 0.05, 1, 5, 10, 20]);
});
