import type { DataFormat, TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { MAX_LINES, TopicHistory } from './topic-history.ts';

const record = (format: DataFormat, value: unknown, timestampMs?: number): TopicRecord =>
  ({ topic: '/a', format, value, timestampMs, clientId: '' }) as TopicRecord;

describe('TopicHistory', () => {
  it('lists the newest records, newest first, and counts all', () => {
    const history = new TopicHistory();
    for (let i = 1; i <= 1000; i++) history.add(record('double', i, i * 10), i * 10);
    const lines = history.lines();
    expect(lines).toHaveLength(MAX_LINES);
    expect(lines.map(({ number }) => number).slice(0, 3)).toEqual([1000, 999, 998]);
    expect(lines[0]).toMatchObject({ text: formatNumber(1000, 2), numbers: [1000], deltaMs: 10 });
    expect(history.count).toBe(1000);
  });

  it('measures between records by the clock of the publisher', () => {
    const history = new TopicHistory();
    history.add(record('double', 1, 1000), 50_000);
    history.add(record('double', 2, 1010), 50_031);
    expect(history.lines().map(({ deltaMs }) => deltaMs)).toEqual([10, undefined]);
  });

  it('measures by arrival when the publisher gives no time', () => {
    const history = new TopicHistory();
    history.add(record('bool', true), 100);
    history.add(record('bool', false, 7), 130);
    history.add(record('bool', true), 150);
    expect(history.lines().map(({ deltaMs }) => deltaMs)).toEqual([20, 30, undefined]);
    expect(history.lines().map(({ timeMs }) => timeMs)).toEqual([150, 7, 100]);
  });

  it('keeps the points of what can be drawn', () => {
    const history = new TopicHistory();
    history.add(record('vector2', { x: 1, y: 2 }, 0), 100);
    history.add(record('vector2', { x: 3, y: 4 }, 10), 110);
    expect(history.series?.names).toEqual(['x', 'y']);
    expect(history.points?.size).toBe(2);
    expect(history.points?.valueAt(1, 1)).toBe(4);
    expect(history.lineOf('y')?.valueAt(1)).toBe(4);
  });

  it('keeps the newest value whole and of the others one line only', () => {
    const history = new TopicHistory();
    const image = { width: 1, height: 1, dataFormat: 0, data: new Uint8Array(1) };
    history.add(record('image2D', image), 0);
    expect(history.latest?.value).toBe(image);
    expect(history.lines()[0]).toMatchObject({ text: '1×1 GRAY8, 1 B', numbers: undefined });
    expect(history.series).toBeUndefined();
  });

  it('begins a new drawing when the data format changes', () => {
    const history = new TopicHistory();
    history.add(record('double', 1), 0);
    history.add(record('vector2', { x: 1, y: 2 }), 10);
    expect(history.series?.names).toEqual(['x', 'y']);
    expect(history.points?.size).toBe(1);
    expect(history.count).toBe(2);
  });

  it('finds every number of a value by its path', () => {
    const history = new TopicHistory();
    const pose = { position: { x: 1, y: 2, z: 3 }, quaternion: { x: 0, y: 0, z: 0, w: 1 } };
    history.add(record('object3D', { id: 'cup', pose }), 0);
    expect(history.fields).toContain('pose.quaternion.w');
    expect(history.lineOf('pose.position.z')?.valueAt(0)).toBe(3);
  });

  it('keeps a number that is asked for from then on', () => {
    const history = new TopicHistory();
    expect(history.lineOf('a.b')).toBeUndefined();
    history.add(record('string', '{"a":{}}'), 0);
    history.add(record('string', '{"a":{"b":7}}'), 10);
    expect([0, 1].map((i) => history.lineOf('a.b')?.valueAt(i))).toEqual([Number.NaN, 7]);
  });

  it('keeps records and points for so long, within so much memory', () => {
    const aged = new TopicHistory({ maxAgeMs: 1000, maxBytes: 64_000_000 });
    for (let i = 0; i < 5000; i++) aged.add(record('double', i), i);
    expect(aged.records.size).toBe(1001);
    expect(aged.points?.size).toBe(1001);
    const small = new TopicHistory({ maxAgeMs: 600_000, maxBytes: 100_000 });
    for (let i = 0; i < 20_000; i++) small.add(record('vector3', { x: i, y: 0, z: 0 }), i);
    expect(small.bytes).toBeLessThanOrEqual(100_000);
    expect(small.records.size).toBeGreaterThan(100);
    expect(small.lineAt(20_000)?.numbers?.[0]).toBe(19_999);
    expect(small.lineAt(1)).toBeUndefined();
  });

  it('holds twenty numbers of ten minutes at 60 Hz', () => {
    const history = new TopicHistory();
    const value = { elements: Array.from({ length: 20 }, (_, i) => i) };
    const fields = Array.from({ length: 20 }, (_, i) => `elements.${i}`);
    for (const field of fields) history.lineOf(field);
    for (let i = 0; i < 36_000; i++) history.add(record('doubleList', value), i * (1000 / 60));
    expect(history.points?.size).toBe(36_000);
    expect(history.bytes).toBeLessThan(64_000_000);
    expect(history.lineOf('elements.19')?.valueAt(0)).toBe(19);
  });

  it('finds the record nearest to a moment', () => {
    const history = new TopicHistory();
    for (const ms of [0, 100, 200]) history.add(record('double', ms), ms);
    const at = (ms: number, upTo?: number) => history.records.nearest(ms, upTo)?.number;
    expect([at(-5), at(60), at(149), at(999), at(999, 2)]).toEqual([1, 2, 2, 3, 2]);
    expect(new TopicHistory().records.nearest(0)).toBeUndefined();
  });
});
