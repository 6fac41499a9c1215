import type { Object3D, TopicRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { MarkerReadings } from './marker-readings.ts';

const markers = [{ id: 'aruco_4x4_50:7' } as Object3D];
const outlines = { topic: '/outlines' } as TopicRecord;

it('joins markers and outlines of the same picture only, in any order', () => {
  const readings = new MarkerReadings();
  expect(readings.take(1000, { markers })).toBeUndefined();
  expect(readings.take(1100, { outlines })).toBeUndefined();
  expect(readings.take(1100, { markers })).toEqual({ markers, outlines });
  expect(readings.take(1000, { outlines })).toEqual({ markers, outlines });
});

it('forgets pictures whose other half does not come, and all when it is cleared', () => {
  const readings = new MarkerReadings();
  for (let takenMs = 0; takenMs < 10; takenMs++) readings.take(takenMs, { markers });
  expect(readings.take(0, { outlines })).toBeUndefined();
  readings.clear();
  expect(readings.take(9, { outlines })).toBeUndefined();
});
