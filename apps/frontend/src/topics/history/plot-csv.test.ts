import { expect, it } from 'vitest';
import { plotCsv } from './plot-csv.ts';
import { aLine } from '../plot/testing/a-line.ts';
import { clockTicks, spanText, ticksBefore } from '../plot/time-ticks.ts';

it('writes what is in the window, one row for each moment of any line', () => {
  const a = aLine([
    [0, 0],
    [1000, 1.5],
    [2000, Number.NaN],
    [9000, 9],
  ]);
  const b = aLine([
    [1000, -2],
    [1500.25, Infinity],
  ]);
  const columns = [
    { name: 'a, first', points: a },
    { name: '=b', points: b },
    { name: 'none', points: undefined },
  ];
  expect(plotCsv(columns, 500, 5000).split('\r\n')).toEqual([
    `time,time_ms,"a, first",'=b,none`,
    '1970-01-01T00:00:01.000Z,1000,1.5,-2,',
    '1970-01-01T00:00:01.500Z,1500.25,,Infinity,',
    '1970-01-01T00:00:02.000Z,2000,NaN,,',
    '',
  ]);
});

it('lines of the grid stand at round distances from the end, or at round times of the day', () => {
  const texts = (span: number) => ticksBefore(50_000, 50_000 + span, 5, 'now').map((t) => t.text);
  expect(texts(10_000)).toEqual(['−10 s', '−8 s', '−6 s', '−4 s', '−2 s', 'now']);
  expect(texts(600_000).slice(-3)).toEqual(['−4 min', '−2 min', 'now']);
  expect(clockTicks(50_300, 52_000, 4).map(({ timeMs }) => timeMs)).toEqual([
    50_500, 51_000, 51_500, 52_000,
  ]);
  expect([250, 10_000, 90_000].map(spanText)).toEqual(['250 ms', '10 s', '1.5 min']);
});
