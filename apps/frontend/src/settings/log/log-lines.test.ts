import { LogLevel, type LogLine } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { addTail, EMPTY_LOG, filterLines, linesText, MAX_LINES } from './log-lines.ts';

const line = (number: number, changes: Partial<LogLine> = {}): LogLine => ({
  number,
  timeMs: 0,
  level: LogLevel.LOG_INFO,
  message: `line ${number}`,
  fields: [],
  ...changes,
});
const lines = (from: number, count: number) =>
  Array.from({ length: count }, (_, i) => line(from + i));
const tail = (changes: object) => ({ cursor: 7, reset: false, missed: 0, lines: [], ...changes });

describe('addTail', () => {
  it('adds what is new, and remembers where to go on', () => {
    const first = addTail(EMPTY_LOG, tail({ reset: true, lines: lines(1, 2) }));
    const next = addTail(first, tail({ cursor: 9, lines: lines(3, 1) }));
    expect(next.cursor).toBe(9);
    expect(next.lines.map(({ number }) => number)).toEqual([1, 2, 3]);
    expect(next.missed).toBe(0);
  });

  it('keeps so many lines, and counts those that went', () => {
    const full = addTail(EMPTY_LOG, tail({ reset: true, lines: lines(1, MAX_LINES) }));
    const next = addTail(full, tail({ missed: 5, lines: lines(MAX_LINES + 6, 2) }));
    expect(next.lines).toHaveLength(MAX_LINES);
    expect(next.lines.at(-1)?.number).toBe(MAX_LINES + 7);
    expect(next.missed).toBe(7);
  });

  it('starts over with a master that was started again', () => {
    const before = { ...EMPTY_LOG, lines: lines(1, 9), missed: 3 };
    const next = addTail(before, tail({ reset: true, lines: lines(1, 1) }));
    expect([next.lines.length, next.missed]).toEqual([1, 0]);
  });
});

it('lines are found by level, words and values', () => {
  const all = [
    line(1, { level: LogLevel.LOG_ERROR, message: 'a disk is full' }),
    line(2, { fields: [{ name: 'clientId', value: 'Mara' }] }),
    line(3, { level: LogLevel.LOG_DEBUG }),
  ];
  const found = (level: LogLevel, search = '') =>
    filterLines(all, level, search).map(({ number }) => number);
  expect(found(LogLevel.LOG_DEBUG)).toEqual([1, 2, 3]);
  expect(found(LogLevel.LOG_INFO)).toEqual([1, 2]);
  expect(found(LogLevel.LOG_WARN)).toEqual([1]);
  expect(found(LogLevel.LOG_DEBUG, 'clientid=mara')).toEqual([2]);
  expect(found(LogLevel.LOG_DEBUG, 'full DISK')).toEqual([1]);
});

it('lines as text have time, level, message and values', () => {
  const fields = [
    { name: 'clientId', value: 'c-1' },
    { name: 'why', value: 'too "loud"' },
  ];
  expect(linesText([line(1, { level: LogLevel.LOG_WARN, message: 'Mara left', fields })])).toBe(
    '1970-01-01T00:00:00.000Z WARN  Mara left clientId=c-1 why="too \\"loud\\""\n',
  );
});
