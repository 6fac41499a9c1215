import { encodeRecord, type RecordInit } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { PlayedRecord } from '../opened/played-values.ts';
import { tracksOf } from '../timeline/track.ts';
import { headRows } from './head-value.ts';

function rows(format: string, value: unknown, frames?: number[]): readonly string[] {
  const [track] = tracksOf([{ topic: '/a', clientId: 'c', format, records: 1 }], 1000);
  const record = encodeRecord({ topic: '/a', format, value } as RecordInit);
  const played = new PlayedRecord({ topic: '/a', timeMs: 20, record });
  return headRows(track!, played, frames && Float64Array.from(frames));
}

describe('the head of a track', () => {
  it('has a row for each number of a vector', () => {
    expect(rows('vector3', { x: 6.605, y: -3.729, z: 12.327 })).toEqual([
      '6.605',
      '−3.729',
      '12.327',
    ]);
  });

  it('has the yaw of a rotation, as all numbers have no room there', () => {
    const half = Math.SQRT1_2;
    expect(rows('quaternion', { x: 0, y: 0, z: -half, w: half })).toEqual(['yaw −90°']);
  });

  it('counts things and pictures', () => {
    expect(rows('object2DList', { elements: [{ id: 'a' }, { id: 'b' }] })).toEqual(['2 found']);
    expect(
      rows('image2D', { width: 1, height: 1, data: new Uint8Array(1) }, [0, 10, 20, 30]),
    ).toEqual(['#3']);
  });

  it('says what happened', () => {
    expect(rows('touchEvent', { type: 2, position: { x: 0.5, y: 0.25 } })).toEqual(['end']);
    expect(rows('keyEvent', { key: 'k', type: 1 })).toEqual(['k down']);
    expect(rows('string', 'swipe')).toEqual(['swipe']);
  });

  it('is empty before the first record', () => {
    const [track] = tracksOf([{ topic: '/a', clientId: 'c', format: 'double', records: 1 }], 1);
    expect(headRows(track!, undefined, undefined)).toEqual([]);
  });
});
