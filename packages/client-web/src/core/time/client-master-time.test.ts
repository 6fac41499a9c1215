import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import type { ClientOptions } from '../client/client-options.ts';
import { PING_INTERVAL_MS } from '../connection/link.ts';
import type { MasterTimeEstimate } from './master-time.ts';

const HOUR_MS = 3_600_000;

/** A client whose clock is an hour behind that of its master. */
async function setup(options: Partial<ClientOptions> = {}) {
  const clock = new FakeClock();
  const startMs = clock.nowMs();
  const masterMs = (): number => startMs + HOUR_MS + clock.monotonicMs() + aheadMs;
  let aheadMs = 0;
  const master = new FakeMaster({ timeMs: masterMs });
  const all = createTestClient(master, { ...options, clock });
  const estimates: (MasterTimeEstimate | undefined)[] = [];
  all.client.masterTime.onEstimate((estimate) => estimates.push(estimate));
  await all.client.connect();
  const setMaster = (byMs: number): void => void (aheadMs += byMs);
  return { master, ...all, clock, masterMs, setMaster, estimates };
}

describe('client.masterTime', () => {
  it('is known from the first connection on, with its error [TS-1] [TS-4]', async () => {
    const { client, masterMs, estimates } = await setup();
    const { masterTime } = client;
    const { estimate } = masterTime;
    expect(masterTime.nowMs()).toBe(masterMs());
    expect(estimate).toMatchObject({ offsetMs: HOUR_MS, driftPpm: 0, measuredAt: masterMs() });
    expect(estimate?.errorMs).toBeLessThan(3);
    expect(estimates).toEqual([estimate]);
  });

  it('is less certain the longer there is no answer [TS-4]', async () => {
    const { client, master, clock, masterMs } = await setup();
    await clock.advance(1_000);
    master.isSilent = true;
    const before = client.masterTime.estimate!.errorMs;
    await clock.advance(5_000);
    expect(client.masterTime.estimate!.errorMs).toBeGreaterThan(before);
    expect(client.masterTime.nowMs()).toBeCloseTo(masterMs(), 3);
  });

  it('does not follow this clock when it is set, and is measured again [TS-7]', async () => {
    for (const byMs of [-30_000, 30_000]) {
      const { client, clock, masterMs, estimates } = await setup();
      await clock.advance(10_000);
      clock.setWall(byMs);
      expect(client.masterTime.estimate).toBeUndefined();
      expect(estimates.at(-1)).toBeUndefined();
      await clock.advance(50);
      expect(client.masterTime.nowMs()).toBe(masterMs());
      expect(client.masterTime.estimate?.offsetMs).toBeCloseTo(HOUR_MS - byMs, 3);
    }
  });

  it('continues with the time of day after a sleep, until it is measured again [TS-7]', async () => {
    const { client, master, clock, masterMs, setMaster } = await setup();
    await clock.advance(10_000);
    master.isSilent = true;
    clock.setWall(600_000);
    setMaster(600_000);
    expect(client.masterTime.estimate).toBeUndefined();
    expect(client.masterTime.nowMs()).toBe(masterMs());
    master.isSilent = false;
    await clock.advance(50);
    expect(client.masterTime.estimate).toMatchObject({ offsetMs: HOUR_MS });
  });

  it('believes in another master time when it was told it twice [TS-6]', async () => {
    const { client, clock, masterMs, setMaster } = await setup();
    await clock.advance(10_000);
    setMaster(500);
    await clock.advance(PING_INTERVAL_MS); // the first one asks for more of them
    await clock.advance(100);
    expect(client.masterTime.nowMs()).toBe(masterMs());
  });

  it('is measured again on a new link: its master may be another one [TS-8]', async () => {
    const { client, master, clock, masterMs, setMaster } = await setup();
    await clock.advance(10_000);
    master.restart();
    setMaster(-HOUR_MS);
    await clock.advance(5_000);
    expect(client.state.status).toBe('connected');
    expect(client.masterTime.nowMs()).toBe(masterMs());
  });

  it('is the time of this machine with a master that does not tell it', async () => {
    const master = new FakeMaster();
    const { client, clock } = createTestClient(master, { stampInMasterTime: true });
    await client.connect();
    await clock.advance(10_000);
    expect(client.masterTime.estimate).toBeUndefined();
    expect(client.masterTime.nowMs()).toBe(clock.nowMs());
    expect(new Set(master.texts)).toEqual(new Set(['PING']));
    client.publish('/a', 'double', 1);
    await clock.advance(0);
    expect(master.published).toMatchObject([{ timestampMs: clock.nowMs() }]);
  });

  it('tells the master what is known of the clock [TS-10]', async () => {
    const { master, clock } = await setup();
    await clock.advance(PING_INTERVAL_MS);
    expect(master.texts[0]).toBe('PING 1');
    expect(master.texts.at(-1)).toMatch(/^PING \d+ 3600000\.000 \d\.\d{3} -?\d+\.\d$/);
  });
});

describe('records stamped in master time [TS-9]', () => {
  it('are those of a client, or single ones, that ask for it', async () => {
    for (const stampInMasterTime of [undefined, false, true]) {
      const { client, master, clock, masterMs } = await setup({ stampInMasterTime });
      client.publish('/a', 'double', 1);
      client.publish('/b', 'double', 1, { stampInMasterTime: true });
      client.publish('/c', 'double', 1, { stampInMasterTime: false });
      client.publish('/d', 'double', 1, {
        stampInMasterTime: true,
        timestampMs: 1_600_000_000_000,
      });
      const expected: number[] = [
        stampInMasterTime ? masterMs() : clock.nowMs(),
        masterMs(),
        clock.nowMs(),
        1_600_000_000_000,
      ];
      await clock.advance(0);
      expect(master.published.map(({ timestampMs }) => timestampMs)).toEqual(expected);
    }
  });
});
