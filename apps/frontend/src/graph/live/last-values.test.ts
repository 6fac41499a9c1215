import type { DataFormat, TopicRecord } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { LastValues, MAX_PASSED } from './last-values.ts';

const record = (format: DataFormat, value: unknown): TopicRecord =>
  ({ topic: '/a', format, value, timestampMs: undefined, clientId: '' }) as TopicRecord;

describe('the last values', () => {
  it('are kept newest first, and counted', () => {
    const last = new LastValues();
    for (let i = 1; i <= 12; i++) last.add(record('int32', i), i);
    expect(last.values).toHaveLength(MAX_PASSED);
    expect(last.values[0]).toMatchObject({ number: 12, text: '12', atMs: 12 });
    expect(last.count).toBe(12);
  });

  it('draw the number that moves most, over two seconds', () => {
    const last = new LastValues();
    last.add(record('vector2', { x: 100, y: 0 }), 0);
    last.add(record('vector2', { x: 1, y: 2 }), 1500);
    last.add(record('vector2', { x: 1.1, y: 9 }), 2500);
    expect(last.line(2600)).toEqual([2, 9]);
    expect(last.line(9000)).toEqual([]);
  });

  it('draw nothing for what has no numbers', () => {
    const last = new LastValues();
    last.add(record('string', 'hello'), 0);
    expect(last.values[0]?.text).toContain('hello');
    expect(last.line(0)).toEqual([]);
  });

  it('draw no more points than are seen', () => {
    const last = new LastValues();
    for (let i = 0; i < 1000; i++) last.add(record('double', i), i);
    expect(last.line(1000).length).toBeLessThanOrEqual(60);
  });
});
