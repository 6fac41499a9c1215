// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { ReplayAction, ServiceError } from '@ubii/proto';
import { defineComponent, h, shallowRef } from 'vue';
import { afterEach, describe, expect, it } from 'vitest';
import { DEFAULT_LIVE_CHOICE } from './live-choice.ts';
import { aReplay, replayPage, STUDY, type MadeCall } from './testing/replay-page.ts';
import { provideLivePlay, useLivePlay, type LivePlay } from './useLivePlay.ts';

const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

function setUp(reply: (call: MadeCall) => unknown = () => undefined) {
  let live!: LivePlay;
  const Part = defineComponent(() => {
    live = useLivePlay();
    return () => h('p');
  });
  const page = replayPage((player) => provideLivePlay(player, shallowRef(STUDY)), reply, Part);
  wrappers.push(page.wrapper);
  return { ...page, live };
}
const services = (calls: readonly MadeCall[]) => calls.map(({ service }) => service);

describe('playing into live topics', () => {
  it('starts where the playhead is, and controls the replay from then on', async () => {
    const { live, used: player, calls, opened } = setUp(() => aReplay());
    player.seek(400);
    expect(calls).toEqual([]);
    await expect(live.start(DEFAULT_LIVE_CHOICE, ['Mara'])).resolves.toBeUndefined();
    await flushPromises();
    expect(services(calls)).toEqual(['replayStart', 'replayChange']);
    expect(calls[0]!.request).toMatchObject({ recordingId: 'study', isPaused: true });
    expect(calls[1]!.request).toMatchObject({
      id: 'r1',
      seek: { positionMs: 400 },
      action: ReplayAction.REPLAY_ACTION_PLAY,
    });
    expect(live.replay.value?.id).toBe('r1');
    expect(live.publishers.value).toEqual(['Mara']);
    player.setRate(2);
    await flushPromises();
    expect(calls[2]!.request).toEqual({ id: 'r1', rate: 2 });
    expect(opened.sent.at(-1)).toEqual(['setRate', 2]);
  });

  it('says why the master refuses to play it', async () => {
    const { live } = setUp(() => {
      throw new ServiceError('failed_precondition', 'Another replay plays /a.');
    });
    await expect(live.start(DEFAULT_LIVE_CHOICE, [])).resolves.toBe('Another replay plays /a.');
    expect(live.problem.value).toBeUndefined();
    expect(live.replay.value).toBeUndefined();
  });

  it('follows a replay of this recording that others started; ghosts and sessions have their own', async () => {
    const { live, news } = setUp();
    await news(
      aReplay({ id: 'other', recordingId: 'walk' }),
      aReplay({ id: 'ghost', isGhost: true }),
    );
    expect(live.replay.value).toBeUndefined();
    await news(aReplay({ id: 'r2' }));
    expect(live.replay.value?.id).toBe('r2');
    await news();
    expect(live.replay.value).toBeUndefined();
  });

  it('plays on this page only after a stop that the master refused, until it is resumed', async () => {
    const { live, news } = setUp(() => {
      throw new ServiceError('permission_denied', 'Ada started it.');
    });
    await news(aReplay());
    await live.stop();
    expect(live.problem.value).toBe('Ada started it.');
    await news(aReplay({ positionMs: 100 }));
    expect(live.replay.value).toBeUndefined();
    expect(live.resume()).toBe(true);
    expect(live.replay.value?.id).toBe('r1');
  });
});
