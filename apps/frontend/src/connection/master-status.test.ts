import type { MasterStatus, StatusSample } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { measureClock } from './clock-offset.ts';
import {
  cpuShare,
  HISTORY_MS,
  mergeMasterStatus,
  nextSinceMs,
  recordsPerSecond,
  type MasterView,
} from './master-status.ts';

const START = 1_000_000;

function reply(nowMs: number, changes: Partial<MasterStatus> = {}): MasterStatus {
  return {
    masterId: 'm',
    startedMs: START,
    nowMs,
    samples: [],
    events: [],
    problems: [],
    addresses: [],
    ...changes,
  } as unknown as MasterStatus;
}
const sample = (timeMs: number, rate = 1): StatusSample => ({
  timeMs,
  recordsPerSecond: rate,
  cpuPercent: 0,
  busyPercent: 0,
  delayMs: 0,
  recordsOutPerSecond: 0,
});
const event = (timeMs: number, text: string) => ({ timeMs, kind: 0, text, clientId: '' }) as const;

function merge(known: MasterView | undefined, next: MasterStatus): MasterView {
  return mergeMasterStatus(known, next, next.nowMs - 10, next.nowMs + 10);
}

it('tells the master’s share of all processors of its machine, by the newest sample', () => {
  const samples = [sample(START, 1), { ...sample(START + 2000, 1), cpuPercent: 32 }];
  expect(cpuShare(merge(undefined, reply(START + 2500, { samples, processors: 4 })))).toBe(8);
  expect(cpuShare(merge(undefined, reply(START, { processors: 4 })))).toBeUndefined();
  expect(cpuShare(undefined)).toBeUndefined();
});

describe('mergeMasterStatus', () => {
  it('puts the samples of several replies together, each once', () => {
    const first = merge(undefined, reply(START + 5000, { samples: [sample(START + 2000)] }));
    const second = merge(
      first,
      reply(START + 6000, { samples: [sample(START + 2000), sample(START + 6000, 7)] }),
    );
    expect(second.samples.map(({ timeMs }) => timeMs - START)).toEqual([2000, 6000]);
    expect(recordsPerSecond(second)).toBe(7);
  });

  it('keeps two events of one millisecond and drops one that comes twice', () => {
    const first = merge(undefined, reply(START + 5, { events: [event(START + 4, 'Mara joined')] }));
    const second = merge(
      first,
      reply(START + 9, {
        events: [event(START + 4, 'Mara joined'), event(START + 4, 'Theo joined')],
      }),
    );
    expect(second.events.map(({ text }) => text)).toEqual(['Mara joined', 'Theo joined']);
  });

  it('forgets what is older than the history', () => {
    const first = merge(undefined, reply(START + 1, { samples: [sample(START)] }));
    expect(merge(first, reply(START + HISTORY_MS + 1)).samples).toEqual([]);
  });

  it('starts over with a master that was restarted', () => {
    const first = merge(undefined, reply(START + 1, { samples: [sample(START)] }));
    const second = merge(first, reply(START + 9, { startedMs: START + 8 }));
    expect(second.samples).toEqual([]);
  });

  it('asks for everything first, then from just before the newest reply', () => {
    expect(nextSinceMs(undefined)).toBe(0);
    expect(nextSinceMs(merge(undefined, reply(START + 100)))).toBe(START + 99);
  });
});

describe('measureClock', () => {
  it('takes the middle between question and answer, with half of it as the error', () => {
    expect(measureClock(undefined, 100, 120, 1110)).toEqual({
      offsetMs: 1000,
      errorMs: 10,
      measuredMs: 120,
    });
  });

  it('keeps a quick measurement against a slow one, until drift has made it worse', () => {
    const quick = measureClock(undefined, 0, 2, 1001);
    expect(measureClock(quick, 1000, 1040, 2050)).toBe(quick);
    expect(measureClock(quick, 400_000, 400_040, 401_020).errorMs).toBe(20);
  });
});
