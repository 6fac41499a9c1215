import { ReplayAction, ReplayState } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { at, change, heard, list, listener, masterWith, play } from './replay-world.ts';

const { REPLAY_STATE_PLAYING, REPLAY_STATE_PAUSED, REPLAY_STATE_ENDED } = ReplayState;
const { REPLAY_ACTION_PLAY, REPLAY_ACTION_PAUSE } = ReplayAction;

describe('a replay that is controlled', () => {
  it('[RP-5] [RP-11] pauses, jumps with the last values, steps, and changes its rate', async () => {
    const master = await masterWith();
    const ada = await listener(master);
    const { id } = await play(master, { isPaused: true });
    expect(heard(ada)).toEqual([['/a', 0]]);
    await master.pass(500);
    expect(heard(ada)).toEqual([]);
    const jumped = await change(master, { id, seek: { positionMs: 450 } });
    expect(jumped).toMatchObject({ state: REPLAY_STATE_PAUSED, positionMs: 450 });
    expect(heard(ada).sort()).toEqual([
      ['/a', 400],
      ['/b', 50],
    ]);
    expect(await change(master, { id, step: 2 })).toMatchObject({ positionMs: 600 });
    expect(heard(ada)).toEqual([
      ['/a', 500],
      ['/a', 600],
    ]);
    await change(master, { id, step: -1 });
    expect(heard(ada)).toContainEqual(['/a', 500]);
    const playing = await change(master, { id, rate: 10, action: REPLAY_ACTION_PLAY });
    expect(playing).toMatchObject({ state: REPLAY_STATE_PLAYING, rate: 10 });
    await master.pass(80);
    expect(heard(ada).map(([, value]) => value)).toEqual([600, 700, 800, 900, 1_000]);
    await change(master, { id, action: REPLAY_ACTION_PLAY });
    expect(await change(master, { id, action: REPLAY_ACTION_PAUSE })).toMatchObject({
      state: REPLAY_STATE_PAUSED,
    });
    expect(heard(ada)[0]).toEqual(['/a', 0]);
  });

  it('[RP-5] plays a span once or in a loop', async () => {
    const master = await masterWith();
    const ada = await listener(master);
    const { id } = await play(master, { span: { fromMs: 300, untilMs: 500 }, isLooping: true });
    await master.pass(480);
    expect(
      heard(ada)
        .filter(([topic]) => topic === '/a')
        .map(([, value]) => value),
    ).toEqual([300, 400, 500, 300, 400, 500, 300]);
    const once = await change(master, { id, loop: { span: { fromMs: 800 } } });
    expect(once).toMatchObject({ isLooping: false, span: { fromMs: 800, untilMs: 1_000 } });
    await master.pass(300);
    expect((await list(master))[0]!.state).toBe(REPLAY_STATE_ENDED);
    expect(heard(ada).at(-1)).toEqual(['/a', 1_000]);
  });

  it('[RP-11] jumps in a recording of 1000 topics', async () => {
    const topics = Array.from({ length: 1_000 }, (_, index) =>
      at(`/t/${index}`, index / 10, index),
    );
    const master = await masterWith([...topics, at('/end', 1_000)]);
    const ada = await listener(master);
    const { id } = await play(master, { isPaused: true });
    await change(master, { id, seek: { positionMs: 500 } });
    expect(new Map(heard(ada))).toEqual(
      new Map(topics.map(({ topic }, index) => [topic, index] as const)),
    );
  });
});
