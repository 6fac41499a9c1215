import { expect, it } from 'vitest';
import { readCalibrations, withCalibration } from './calibration-memory.ts';

const json = (fx: number) =>
  JSON.stringify({ width: 640, height: 480, fx, fy: 600, cx: 320, cy: 240 });

it('keeps one calibration for each camera, and lets go of those of long ago', () => {
  let kept = withCalibration(new Map(), '', json(1));
  expect(kept.size).toBe(0);
  for (let i = 0; i < 12; i++) kept = withCalibration(kept, `camera ${i}`, json(500 + i));
  kept = withCalibration(kept, 'camera 6', json(700));
  expect(kept.size).toBe(8);
  expect([...kept.keys()].at(-1)).toBe('camera 6');
  expect(readCalibrations(JSON.stringify([...kept])).get('camera 6')).toBe(json(700));
});

it('reads the valid part of what another program wrote', () => {
  for (const text of ['', 'null', '{}', '[', '[[]]', '[null]']) {
    expect(readCalibrations(text).size, text).toBe(0);
  }
  const mixed = JSON.stringify([
    ['a', '{}'],
    ['', json(1)],
    ['b', json(2)],
    ['c', 7],
  ]);
  expect([...readCalibrations(mixed).keys()]).toEqual(['b']);
});
