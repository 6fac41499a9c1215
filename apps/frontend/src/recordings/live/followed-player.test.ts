import { ReplayAction, ReplayState, type Replay } from '@ubii/proto';
import { nextTick, shallowRef } from 'vue';
import { describe, expect, it } from 'vitest';
import { aRecording, fakeRecording } from '../opened/testing/fake-recording.ts';
import type { PlayerState } from '../reading/recording-messages.ts';
import { createFollowedPlayer } from './followed-player.ts';
import type { ReplayChange } from './replay-control.ts';

function setUp(replay?: Replay) {
  const changes: ReplayChange[] = [];
  // The file begins 100 ms after the recording of the master, with its first record.
  const { player: local, sent, page } = fakeRecording(aRecording({ startMs: 1100 }));
  const news = shallowRef(replay);
  const state = { isBusy: false };
  const player = createFollowedPlayer(local, {
    replay: news,
    change: (change) => changes.push(change),
    isBusy: () => state.isBusy,
  });
  sent.length = 0;
  const arrive = (change: Partial<PlayerState>): void =>
    page.showPlayer({ ...local.player.value, ...change });
  return { player, sent, changes, news, state, arrive };
}
const aReplay = (change: Partial<Replay>): Replay =>
  ({
    state: ReplayState.REPLAY_STATE_PAUSED,
    positionMs: 100,
    rate: 1,
    isLooping: false,
    span: { fromMs: 0, untilMs: 1100 },
    recordingStartedMs: 1000,
    ...change,
  }) as Replay;

describe('a page that follows a replay', () => {
  it('controls it, with times of the master', async () => {
    const { player, changes, sent, arrive } = setUp(aReplay({}));
    player.togglePlay();
    player.seek(400);
    player.setRate(2);
    player.setLoop({ fromMs: 10, untilMs: 20 });
    player.setLoop(undefined);
    expect(changes).toEqual([
      { action: ReplayAction.REPLAY_ACTION_PLAY },
      { seek: { positionMs: 500 } },
      { rate: 2 },
      { loop: { isLooping: true, span: { fromMs: 110, untilMs: 120 } } },
      { loop: { isLooping: false } },
    ]);
    expect(sent.map(([name]) => name)).toEqual(['play', 'seek', 'setRate', 'setLoop', 'setLoop']);
    arrive({ status: 'playing', timeMs: 400 });
    await nextTick();
    player.togglePlay();
    expect(changes.at(-1)).toEqual({ action: ReplayAction.REPLAY_ACTION_PAUSE });
  });

  it('sends a step when it knows where it leads', async () => {
    const { player, changes, arrive } = setUp(aReplay({}));
    player.stepRecord('/a', 1);
    expect(changes).toEqual([{ action: ReplayAction.REPLAY_ACTION_PAUSE }]);
    arrive({ timeMs: 40 });
    await nextTick();
    expect(changes[1]).toEqual({ seek: { positionMs: 140 } });
  });

  it('goes where others move it, but does not jump while both play the same', async () => {
    const { player, sent, news, arrive } = setUp(aReplay({}));
    news.value = aReplay({ positionMs: 600 });
    await nextTick();
    expect(player.timeMs.value).toBe(500);
    arrive({ timeMs: 500 });
    const state = ReplayState.REPLAY_STATE_PLAYING;
    news.value = aReplay({ positionMs: 610, state, rate: 2 });
    await nextTick();
    arrive({ status: 'playing', rate: 2, timeMs: 520 });
    sent.length = 0;
    news.value = aReplay({ positionMs: 660, state, rate: 2 });
    await nextTick();
    expect(sent).toEqual([]);
    news.value = aReplay({ positionMs: 660, state, rate: 2, isLooping: true });
    await nextTick();
    expect(sent).toEqual([['setLoop', { fromMs: 0, untilMs: 1000 }]]);
  });

  it('ignores news while a change of its own is on its way', async () => {
    const { player, news, state } = setUp(aReplay({}));
    state.isBusy = true;
    news.value = aReplay({ positionMs: 600 });
    await nextTick();
    expect(player.timeMs.value).toBe(0);
  });

  it('plays on this page only while there is no replay', () => {
    const { player, changes, sent } = setUp();
    player.togglePlay();
    player.seek(10);
    player.stepTime(5);
    expect(changes).toEqual([]);
    expect(sent.map(([name]) => name)).toEqual(['play', 'seek', 'stepTime']);
  });
});
