import { expect, it } from 'vitest';
import { eyeOf, orbitKey, pan, startOrbit, turn, zoom } from './orbit.ts';
import { MAX_TRAIL, Trails } from './trails.ts';

const start = startOrbit({ center: [0, 0, 0], radius: 2 });

it('looks from its distance, whichever axis points up', () => {
  for (const up of ['y', 'z'] as const) {
    expect(Math.hypot(...eyeOf(start, up))).toBeCloseTo(start.distance);
  }
  const front = { ...start, azimuth: 0, elevation: 0 };
  expect(eyeOf(front, 'y')).toEqual([0, 0, front.distance]);
  expect(eyeOf(front, 'z')[1]).toBeCloseTo(-front.distance);
  const above = turn(front, 0, 10);
  expect(eyeOf(above, 'y')[1]).toBeCloseTo(above.distance, 1);
  expect(eyeOf(above, 'z')[2]).toBeCloseTo(above.distance, 1);
});

it('is turned, moved and zoomed by keys', () => {
  expect(orbitKey(start, 'ArrowLeft', false, 'y')?.azimuth).toBeLessThan(start.azimuth);
  expect(orbitKey(start, 'ArrowUp', false, 'y')?.elevation).toBeGreaterThan(start.elevation);
  expect(orbitKey(start, '+', false, 'y')?.distance).toBeLessThan(start.distance);
  expect(orbitKey(start, 'ArrowRight', true, 'y')?.target).not.toEqual(start.target);
  expect(orbitKey(start, 'a', false, 'y')).toBeUndefined();
});

it('moves in the plane of the screen, and never past what can be seen', () => {
  const front = { ...start, azimuth: 0, elevation: 0 };
  const moved = pan(front, 0.5, 0, 'y').target;
  expect(moved[0]).toBeGreaterThan(0);
  expect(moved[1]).toBeCloseTo(0);
  expect(zoom(start, 1e-30).distance).toBeGreaterThan(0);
  expect(zoom(start, 1e30).distance).toBeLessThan(1e7);
});

it('trails are bounded, and go with their things', () => {
  const trails = new Trails();
  const at = (x: number) =>
    ({ key: 'a', name: '', at: [x, 0, 0], mark: 'dot', isToScale: false }) as const;
  for (let x = 0; x < MAX_TRAIL + 10; x++) trails.add([at(x)]);
  expect(trails.lines.get('a')).toHaveLength(MAX_TRAIL);
  trails.add([at(MAX_TRAIL + 9)]);
  expect(trails.lines.get('a')?.at(-1)).toEqual([MAX_TRAIL + 9, 0, 0]);
  trails.add([]);
  expect(trails.lines.size).toBe(0);
});
