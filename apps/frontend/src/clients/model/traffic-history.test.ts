import { expect, it } from 'vitest';
import { anActivity } from '../testing/a-client.ts';
import { TRAFFIC_MS, TrafficHistory } from './traffic-history.ts';

const sending = (clientId: string, recordsInPerSecond: number) =>
  anActivity({ clientId, recordsInPerSecond });

it('remembers what each client sent, for a while', () => {
  const history = new TrafficHistory();
  for (let i = 0; i < 1000; i++) history.add(i * 700, [sending('a', i)]);
  const { sends } = history.of('a');
  expect(sends.at(-1)).toEqual({ timeMs: 999 * 700, value: 999 });
  expect(999 * 700 - sends[0]!.timeMs).toBeLessThanOrEqual(TRAFFIC_MS);
  expect(sends.length).toBeGreaterThan(400);
});

it('begins with a client when it comes, and forgets it when it goes', () => {
  const history = new TrafficHistory();
  history.add(1000, [sending('a', 1)]);
  history.add(2000, [sending('a', 2), sending('b', 5)]);
  expect(history.of('b').sends).toEqual([{ timeMs: 2000, value: 5 }]);
  history.add(3000, [sending('b', 6)]);
  expect(history.of('a').sends).toEqual([]);
  expect(history.of('unknown')).toEqual({ sends: [], gets: [] });
});

it('takes a report once', () => {
  const history = new TrafficHistory();
  history.add(1000, [sending('a', 1)]);
  history.add(1000, [sending('a', 1)]);
  expect(history.of('a').sends).toHaveLength(1);
});
