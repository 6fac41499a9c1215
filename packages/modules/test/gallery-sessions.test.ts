import { decodeRecord, DATA_FORMATS, type Image2D } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { EXAMPLE_SESSIONS } from '../src/index.ts';
import { startSession, type SessionWorld } from './session-world.ts';

type Name = keyof typeof EXAMPLE_SESSIONS;

/** Starts an example, lets its time pass, and gives what it put out on its topics. */
async function play(
  name: Name,
  ms: number,
): Promise<SessionWorld & { on(topic: string): unknown[] }> {
  const world = await startSession(EXAMPLE_SESSIONS[name]);
  await world.clock.advance(ms);
  return Object.assign(world, {
    on: (topic: string) => world.values(`/examples/${name}/${topic}`),
  });
}

const spread = (values: readonly unknown[]): number =>
  Math.max(...(values as number[])) - Math.min(...(values as number[]));

describe('an example session', () => {
  it('sine-wave makes a wave from −1 to 1', async () => {
    const { on, events } = await play('sine-wave', 3_000);
    expect(on('wave').length).toBeGreaterThan(150);
    expect(spread(on('wave'))).toBeCloseTo(2, 1);
    expect(events).toEqual([]);
  });

  it('mixed-waves adds what its two waves are', async () => {
    const { on, events } = await play('mixed-waves', 3_000);
    expect(spread(on('slow'))).toBeCloseTo(2, 1);
    expect(spread(on('fast'))).toBeCloseTo(0.8, 1);
    expect(spread(on('mixed'))).toBeGreaterThan(2.2);
    expect(events).toEqual([]);
  });

  it('pointer-speed gives a speed, and 0 for a resting pointer', async () => {
    const { clock, topics, on, events } = await play('pointer-speed', 0);
    for (let step = 0; step <= 20; step += 1) {
      topics.put('/examples/pointer-speed/pointer', 'vector2', { x: step / 20, y: 0 });
      await clock.advance(50);
    }
    expect(on('speed').at(-1)).toBeCloseTo(1, 0);
    await clock.advance(2_000);
    expect(on('speed').at(-1)).toBeCloseTo(0, 3);
    expect(events).toEqual([]);
  });

  it('pointer-color gives another colour for each place', async () => {
    const { clock, topics, on, events } = await play('pointer-color', 0);
    for (const x of [0, 0.25, 0.5, 0.75]) {
      topics.put('/examples/pointer-color/pointer', 'vector2', { x, y: 0.5 });
      await clock.endTurn();
    }
    expect(new Set(on('hex')).size).toBe(4);
    expect(on('color')).toHaveLength(4);
    expect(events).toEqual([]);
  });

  it('click-counter counts presses until it is reset', async () => {
    const { clock, topics, on, events } = await play('click-counter', 0);
    const put = async (topic: string, value: boolean): Promise<void> => {
      topics.put(`/examples/click-counter/${topic}`, 'bool', value);
      await clock.endTurn();
    };
    await put('pressed', false);
    for (const value of [true, false, true, false]) await put('pressed', value);
    await put('reset', true);
    await put('reset', false);
    await put('pressed', true);
    expect(on('count')).toEqual([0, 1, 2, 0, 1]);
    expect(events).toEqual([]);
  });

  it('click-counter counts clicks whose press and release arrive together [PM-25]', async () => {
    const { clock, topics, on, events } = await play('click-counter', 0);
    const put = (value: boolean): void =>
      topics.put('/examples/click-counter/pressed', 'bool', value);
    put(false);
    await clock.endTurn();
    for (let click = 0; click < 5; click += 1) {
      put(true);
      put(false);
      await clock.advance(10);
    }
    expect(on('count').at(-1)).toBe(5);
    expect(events).toEqual([]);
  });

  it('metronome beats twice a second, and compares both modes', async () => {
    const { clock, topics, runtime, on, events } = await play('metronome', 0);
    const PASS_MS = 20;
    for (let pass = 0; pass < 150; pass += 1) {
      await clock.advance(PASS_MS);
      const instanceIds = ['module-1'];
      const records = runtime.lockstepInputs(instanceIds);
      const reply = await runtime.runPass({ instanceIds, deltaTimeMs: PASS_MS, records });
      for (const bytes of reply.records) {
        const record = decodeRecord(bytes);
        if (record.format === undefined) continue;
        topics.publish(record.topic, bytes, DATA_FORMATS[record.format].fieldNumber);
      }
    }
    expect(on('beats').at(-1)).toBeGreaterThanOrEqual(6);
    expect(on('lockstep_ms').at(-1)).toBe(3_000);
    expect(on('frequency_ms').at(-1)).toBeGreaterThan(2_800);
    expect(Math.abs(on('drift_ms').at(-1) as number)).toBeLessThan(200);
    expect(events).toEqual([]);
  });

  it('many-pointers has the middle of all, and answers each [PM-40] [PM-45]', async () => {
    const ANN = '0f8fad5b-d9cb-469f-a165-70867728950e';
    const { clock, topics, on, events } = await play('many-pointers', 500);
    expect(on('count').at(-1)).toBe(2);
    const pointer = `/${ANN}/web-example-mouse-pointer/mouse_client_position`;
    topics.put(pointer, 'vector2', { x: 0.1, y: 0.9 });
    await clock.advance(100);
    expect(on('count').at(-1)).toBe(3);
    for (const who of ['loop', 'wave', ANN]) expect(on(`offset/${who}`)).not.toEqual([]);
    const middle = on('middle').at(-1) as { x: number; y: number };
    const offset = on(`offset/${ANN}`).at(-1) as { x: number; y: number };
    expect(middle.x + offset.x).toBeCloseTo(0.1);
    expect(middle.y + offset.y).toBeCloseTo(0.9);
    topics.delete(pointer);
    await clock.advance(100);
    expect(on('count').at(-1)).toBe(2);
    expect(events).toEqual([]);
  });

  it('hysteresis makes one event of each crossing', async () => {
    const { on, events } = await play('hysteresis', 10_000);
    // The first value is below or above, which is no event: 4 or 5 crossings in 5 waves.
    const rises = on('rise_count').at(-1) as number;
    expect([4, 5]).toContain(rises);
    expect(on('rose')).toHaveLength(rises);
    expect([4, 5]).toContain(on('fell').length);
    expect(events).toEqual([]);
  });

  it('moving-average is calmer than what goes in', async () => {
    const { on, events } = await play('moving-average', 8_000);
    const jumps = (values: readonly unknown[]): number =>
      (values as number[])
        .slice(1)
        .reduce((sum, value, i) => sum + Math.abs(value - (values[i] as number)), 0);
    expect(on('mean').length).toBeGreaterThan(200);
    expect(jumps(on('mean'))).toBeLessThan(jumps(on('noisy')) / 4);
    expect(events).toEqual([]);
  });

  it('picture-edges finds edges in each picture', async () => {
    const { on, events } = await play('picture-edges', 1_000);
    expect(on('picture').length).toBeGreaterThan(8);
    const edges = on('edges').at(-1) as Image2D;
    expect(edges).toMatchObject({ width: 96, height: 54, dataFormat: 0 });
    expect(Math.max(...edges.data)).toBeGreaterThan(200);
    expect(on('grey')).toHaveLength(on('edges').length);
    expect(events).toEqual([]);
  });

  it('key-chord writes what is held', async () => {
    const { clock, topics, on, events } = await play('key-chord', 0);
    for (const [type, key] of [
      [1, 'c'],
      [1, 'e'],
      [0, 'c'],
    ] as const) {
      topics.put('/examples/key-chord/key', 'keyEvent', { type, key });
      await clock.endTurn();
    }
    expect(on('chord')).toEqual(['c', 'c + e', 'e']);
    expect(events).toEqual([]);
  });
});
