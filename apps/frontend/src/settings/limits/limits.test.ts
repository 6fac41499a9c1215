import type { Limit } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { groupLimits, limitReadout, limitRow } from './limit-row.ts';

const limit = (changes: Partial<Limit>): Limit => ({
  name: 'retainedBytes',
  value: 100,
  unit: 'bytes',
  reason: 'Bytes of all retained records.',
  group: 'storage',
  hits: 0,
  use: undefined,
  ...changes,
});
const use = (value: number) => ({ value, clientId: '', sessionId: '' });

describe('limitRow', () => {
  it('says what is allowed, what is used, and what would change it', () => {
    expect(limitRow(limit({ use: use(25) }))).toMatchObject({
      words: 'Retained bytes',
      allowed: { digits: '100', unit: 'B' },
      used: { digits: '25', unit: 'B' },
      share: 0.25,
      state: 'fine',
      flag: '--limits retainedBytes=200',
    });
  });

  it.each([
    [{ use: use(79) }, 'fine'],
    [{ use: use(80) }, 'near'],
    [{ use: use(100) }, 'met'],
    [{ hits: 1 }, 'met'],
    [{}, 'fine'],
  ])('%o is %s', (changes, state) => {
    expect(limitRow(limit(changes)).state).toBe(state);
  });
});

it.each([
  [33_554_432, 'bytes', '34 MB'],
  [1_073_741_824, 'bytes/s', '1.1 GB/s'],
  [500, 'ms', '500 ms'],
  [8000, 'ms', '8 s'],
  [1_200_000, 'ms', '20 min'],
  [50, 'ms/s', '50 ms/s'],
  [10_000, 'clients', '10\u00a0000 clients'],
])('%d %s reads %s', (value, unit, text) => {
  const { digits, unit: shown } = limitReadout(value, unit);
  expect(`${digits} ${shown}`).toBe(text);
});

describe('groupLimits', () => {
  const list = [
    limit({ name: 'topics', unit: 'topics', use: use(95) }),
    limit({ name: 'clients', unit: 'clients', use: use(1) }),
    limit({ name: 'serviceTimeoutMs', unit: 'ms', group: 'time', reason: 'The answer.' }),
  ];

  it('puts what is near first', () => {
    const titles = groupLimits(list, '').map(({ title, rows }) => [
      title,
      rows.map((row) => row.limit.name),
    ]);
    expect(titles).toEqual([
      ['Reached or almost reached', ['topics']],
      ['Storage', ['clients']],
      ['Time', ['serviceTimeoutMs']],
    ]);
  });

  it('is searched by name, words, reason and unit', () => {
    const found = (text: string) =>
      groupLimits(list, text).flatMap(({ rows }) => rows.map((row) => row.limit.name));
    expect(found('service timeout')).toEqual(['serviceTimeoutMs']);
    expect(found('ANSWER')).toEqual(['serviceTimeoutMs']);
    expect(found('clients')).toEqual(['clients']);
    expect(found('nothing like it')).toEqual([]);
  });
});
