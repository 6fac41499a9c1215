import { FakeClock, settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { ConnectionError } from './connection-error.ts';
import type { Outage } from './connection-model.ts';
import { Masters } from './masters.ts';
import { DEFAULT_RECONNECT_POLICY } from './reconnect-policy.ts';
import { Scout } from './scout.ts';

const RECONNECTING = {
  status: 'reconnecting',
  attempt: 1,
  nextAttemptMs: 0,
  error: new ConnectionError('closed', 'broke'),
} as const;

/** Chance that is the same in every run. */
function chances(): () => number {
  let seed = 1;
  return () => (seed = (seed * 16_807) % 2_147_483_647) / 2_147_483_647;
}

/** Scouts of many clients that lost the same master, which does not come back. */
function setup({ clients = 1, isProven = true, answerMs = 0 } = {}) {
  const clock = new FakeClock();
  const random = chances();
  const asked: { readonly url: string; readonly ms: number }[] = [];
  const switches: { readonly url: string; readonly ms: number }[] = [];
  const startMs = clock.monotonicMs();
  const ask = (url: string) => {
    asked.push({ url, ms: clock.monotonicMs() - startMs });
    if (answerMs === 0) return { isProven: Promise.resolve(isProven), cancel: () => undefined };
    let cancel = (): void => undefined;
    const answer = new Promise<boolean>((resolve) => {
      cancel = clock.after(answerMs, () => resolve(isProven));
    });
    return { isProven: answer, cancel };
  };
  const ways = {
    services: { send: () => expect.unreachable() as never },
    topicData: { open: () => expect.unreachable() as never },
  };
  const scouts = Array.from({ length: clients }, () => {
    const masters = new Masters({ url: 'http://a', ...ways }, () => ways);
    masters.learn(['http://b', 'http://c', 'http://d']);
    let outage: Outage = { sinceMs: startMs, failedStartMs: undefined };
    const scout: Scout = new Scout({
      clock,
      random,
      policy: DEFAULT_RECONNECT_POLICY,
      masters,
      ask,
      outage: () => outage,
      recheck: () => {
        outage = { ...outage, failedStartMs: clock.monotonicMs() };
        scout.handleState(RECONNECTING);
      },
      switchTo: (url) => switches.push({ url, ms: clock.monotonicMs() - startMs }),
    });
    scout.handleState(RECONNECTING);
    return scout;
  });
  return { clock, scouts, asked, switches };
}

describe('looking for another master', () => {
  it('[CU-84] spreads the clients over the others, and over a second', async () => {
    const { clock, switches } = setup({ clients: 300 });
    await clock.advance(1_900);
    expect(switches).toEqual([]);
    await clock.advance(1_200);
    expect(switches).toHaveLength(300);
    for (const url of ['http://b', 'http://c', 'http://d']) {
      const share = switches.filter((one) => one.url === url).length;
      expect(share).toBeGreaterThan(75);
    }
    const slots = Array.from({ length: 10 }, (_, i) => 2_000 + i * 100);
    const inSlots = slots.map((from) => switches.filter(({ ms }) => ms >= from && ms < from + 100));
    for (const slot of inSlots) expect(slot.length).toBeGreaterThan(10);
  });

  it('[CU-85] does not go to a server that cannot prove to be of the cluster', async () => {
    const { clock, asked, switches } = setup({ isProven: false });
    await clock.advance(20_000);
    expect(asked.length).toBeGreaterThan(3);
    expect(switches).toEqual([]);
  });

  it('[CU-84] asks all of them in each round, and later rounds more slowly', async () => {
    const { clock, asked } = setup({ isProven: false });
    await clock.advance(60_000);
    const rounds = Array.from({ length: 4 }, (_, i) => asked.slice(i * 3, i * 3 + 3));
    for (const round of rounds) {
      expect(round.map(({ url }) => url).sort()).toEqual(['http://b', 'http://c', 'http://d']);
    }
    const gaps = asked.slice(1).map(({ ms }, i) => ms - asked[i]!.ms);
    expect(Math.max(...gaps.slice(0, 2))).toBeLessThan(500);
    expect(Math.min(...gaps.slice(-3))).toBeGreaterThan(1_250);
    expect(Math.max(...gaps)).toBeLessThanOrEqual(5_000);
  });

  it('[CU-81] waits longer each time: masters to which many come answer late', async () => {
    const { clock, asked, switches } = setup({ answerMs: 7_000 });
    await clock.advance(60_000);
    expect(switches).toHaveLength(1);
    expect(asked).toHaveLength(3);
  });

  it('[CU-82] ends when the own master is there again', async () => {
    const { clock, scouts, asked } = setup({ isProven: false });
    await clock.advance(5_000);
    const before = asked.length;
    scouts[0]!.handleState({ status: 'closed', error: undefined });
    await settle();
    await clock.advance(60_000);
    expect(asked).toHaveLength(before);
    expect(clock.timerCount).toBe(0);
  });
});
