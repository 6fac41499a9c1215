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
});
