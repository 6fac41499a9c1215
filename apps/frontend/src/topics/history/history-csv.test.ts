import type { TopicRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { csvName, historyCsv } from './history-csv.ts';
import { TopicHistory } from './topic-history.ts';

const at = (timestampMs: number, rest: object): TopicRecord =>
  ({ topic: '/a', clientId: '', timestampMs, ...rest }) as TopicRecord;

it('numbers become columns', () => {
  const history = new TopicHistory();
  history.add(at(1000, { format: 'vector2', value: { x: 1, y: 0.5 } }), 1000);
  history.add(at(2000, { format: 'vector2', value: { x: 2, y: Number.NaN } }), 2000);
  expect(historyCsv(history).split('\r\n')).toEqual([
    'time,time_ms,x,y',
    '1970-01-01T00:00:01.000Z,1000,1,0.5',
    '1970-01-01T00:00:02.000Z,2000,2,NaN',
    '',
  ]);
});

it('everything else is a line, and no line is a formula', () => {
  const history = new TopicHistory();
  history.add(at(1000, { format: 'string', value: '=1, "two"' }), 1000);
  expect(historyCsv(history)).toContain(`,1970-01-01T00:00:01.000Z,1000,"'=1, ""two"""`);
  expect(csvName('/lab/arm angle')).toBe('lab-arm-angle.csv');
  expect(csvName('/')).toBe('topic.csv');
});
