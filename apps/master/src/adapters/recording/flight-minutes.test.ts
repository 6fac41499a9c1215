import { DEFAULT_TEXT_LIMITS, encodeRecord } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { addAll, recordsToKeep, runningJob } from '../../testing/acceptance/index.ts';
import { MemoryFolder } from '../../testing/index.ts';
import { readRecording } from '../../testing/read-recording.ts';
import { recordHere } from '@ubii/recording/recorder';

const LIMITS = {
  ...DEFAULT_TEXT_LIMITS,
  recordingsBytes: 1e9,
  markersPerRecording: 100,
  recorderQueueBytes: 1e6,
};

describe('minutes of the flight recorder that are over while nothing comes', () => {
  const FLIGHT = { isOn: true, minutes: 1, maxBytes: 1e6, withImages: true, present: [] };
  const LARGE_BYTES = 20_000;

  /** A flight recorder of a minute that took in three values and a large record. */
  async function openFlight() {
    const folder = new MemoryFolder();
    const clock = new FakeClock();
    const recorder = recordHere({ folder, clock, limits: LIMITS });
    await recorder.setFlight(FLIGHT);
    const timeMs = clock.nowMs();
    const small = recordsToKeep('/x', 3, 1).map((record) => ({ ...record, timeMs }));
    const source = { topic: '/camera', clientId: '', channel: undefined };
    const value = 'x'.repeat(LARGE_BYTES);
    const record = encodeRecord({ topic: '/camera', format: 'string', value });
    addAll(recorder, [...small, { source, record, timeMs, targets: 1 }]);
    await clock.advance(2_000);
    return { recorder, folder, clock };
  }

  async function kept({ recorder, folder }: Awaited<ReturnType<typeof openFlight>>) {
    await recorder.keep(runningJob('kept'));
    return readRecording(await folder.open('kept'));
  }

  it('[RC-30] [RC-33] are not kept, except for values that stand', async () => {
    const world = await openFlight();
    await world.clock.advance(61_000);
    const { summary, values } = await kept(world);
    expect(values).toEqual([['/x', 2]]);
    const beginNs = BigInt(world.clock.nowMs() - 60_000) * 1_000_000n;
    expect(summary.startNs).toBe(beginNs);
  });

  it('[RC-35] leave memory with one timer, and none is left', async () => {
    const { recorder, clock } = await openFlight();
    expect(await recorder.flight()).toMatchObject({ recordCount: 4, topicCount: 2 });
    expect(clock.timerCount).toBe(1);
    const reported: number[] = [];
    recorder.onState(({ flight }) => reported.push(flight.heldBytes));
    await clock.advance(61_000);
    expect(clock.timerCount).toBe(0);
    expect(reported).toHaveLength(1);
    expect(reported[0]).toBeLessThan(LARGE_BYTES);
    const { heldBytes, heldMs, recordCount, topicCount } = await recorder.flight();
    expect({ heldMs, recordCount, topicCount }).toEqual({
      heldMs: 0,
      recordCount: 0,
      topicCount: 1,
    });
    expect(heldBytes).toBe(reported[0]);
  });

  it('[RC-35] leave memory one after the other, and are not kept before', async () => {
    const world = await openFlight();
    const { recorder, clock } = world;
    await clock.advance(28_000);
    const timeMs = clock.nowMs();
    addAll(
      recorder,
      recordsToKeep('/y', 3, 1).map((record) => ({ ...record, timeMs })),
    );
    await clock.advance(31_500);
    expect(await recorder.flight()).toMatchObject({ recordCount: 3, topicCount: 2 });
    const later = [0, 1, 2].map((value) => ['/y', value]);
    expect((await kept(world)).values).toEqual([['/x', 2], ...later]);
    await clock.advance(31_000);
    expect(await recorder.flight()).toMatchObject({ heldMs: 0, recordCount: 0, topicCount: 2 });
    expect(clock.timerCount).toBe(0);
  });

  it.each([
    ['is set back', -3_600_000, 61_000],
    ['is set forward, or the machine slept', 3_600_000, 0],
  ])('[RC-35] are over too when the time of day %s', async (_, byMs, afterMs) => {
    const world = await openFlight();
    world.clock.setWall(byMs);
    await world.clock.advance(afterMs);
    expect((await kept(world)).values).toEqual([['/x', 2]]);
  });

  it('[RC-35] are counted from the record that comes after the clock was set back', async () => {
    const world = await openFlight();
    const { recorder, clock } = world;
    await clock.advance(600_000);
    clock.setWall(-480_000);
    const timeMs = clock.nowMs();
    addAll(
      recorder,
      recordsToKeep('/y', 2, 1).map((record) => ({ ...record, timeMs })),
    );
    await clock.advance(30_000);
    const later = [0, 1].map((value) => ['/y', value]);
    expect((await kept(world)).values).toEqual([['/x', 2], ...later]);
  });

  it('[RC-35] no timer is left when it is turned off, or closed', async () => {
    const { recorder, clock } = await openFlight();
    await recorder.setFlight({ ...FLIGHT, isOn: false });
    expect(clock.timerCount).toBe(0);
    const other = await openFlight();
    await other.recorder.close();
    expect(other.clock.timerCount).toBe(0);
  });

  it('[RC-35] markers that are over are forgotten', async () => {
    const world = await openFlight();
    const { recorder, clock } = world;
    const marker = { recordingId: '', id: 'm', text: 'Ada', author: '', clientId: '' };
    await recorder.mark({
      marker: { ...marker, timeMs: clock.nowMs(), isRemoved: false },
      mayChangeAll: true,
    });
    await clock.advance(62_000);
    expect(clock.timerCount).toBe(0);
    expect((await kept(world)).summary.markers).toEqual([]);
  });
});
