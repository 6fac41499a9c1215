import { ReplayAction, type Recording, type Replay } from '@ubii/proto';
import {
  computed,
  provide,
  shallowRef,
  watch,
  type ComputedRef,
  type InjectionKey,
  type Ref,
  type ShallowRef,
} from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';
import { useAttempt } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useReplays } from '../../connection/live/useReplays.ts';
import type { OpenedPlayer } from '../opened/opened-player.ts';
import { createFollowedPlayer } from './followed-player.ts';
import { liveRequest, type LiveChoice } from './live-choice.ts';
import { ReplayControl } from './replay-control.ts';
import { useMayRecord } from '../rights/useMayRecord.ts';

/** Playing one recording into live topics. */
export interface LivePlay {
  /** The replay that this page follows; undefined while it plays on this page only. */
  readonly replay: ComputedRef<Replay | undefined>;
  /** Why the recording cannot be played into live topics, one sentence. */
  readonly refusal: ComputedRef<string | undefined>;
  /** Why the last request failed, one sentence. */
  readonly problem: ShallowRef<string | undefined>;
  /** Names of clients that published the same topics when this page started the replay. */
  readonly publishers: Readonly<ShallowRef<readonly string[]>>;
  /**
   * Starts where the playhead is, with rate and loop of the page.
   *
   * @param publishers names of the clients that publish these topics now
   * @returns why the master refuses, one sentence; undefined when it plays
   */
  start(choice: LiveChoice, publishers: readonly string[]): Promise<string | undefined>;
  /** Follows again a replay that the master refused to stop. @returns whether there is one */
  resume(): boolean;
  /** Stops the replay; this page no longer follows it, even if the master refuses to stop it. */
  stop(): Promise<void>;
}

const LIVE_PLAY: InjectionKey<LivePlay> = Symbol('live play');

export function useLivePlay(): LivePlay {
  return injectOrThrow(LIVE_PLAY, 'an opened recording above it');
}

/**
 * Provides playing into live topics to the parts of an opened recording.
 *
 * @param recording at the master; undefined for a file of this device
 * @returns the player of the page, which also controls the replay while there is one
 */
export function provideLivePlay(
  local: OpenedPlayer,
  recording: Readonly<Ref<Recording | undefined>>,
): OpenedPlayer {
  const { client } = useConnection();
  const replays = useReplays();
  const mayReplay = useMayRecord();
  const { problem, attempt } = useAttempt();
  const publishers = shallowRef<readonly string[]>([]);
  const leftId = shallowRef<string>();
  /** The reply to the start comes before the news of it. */
  const started = shallowRef<Replay>();
  watch(replays, () => (started.value = undefined));
  const replay = computed(() => {
    const all = started.value ? [...replays.value, started.value] : replays.value;
    return all.find((one) => isReplayOf(one, recording.value?.id) && one.id !== leftId.value);
  });

  const control = new ReplayControl((change) =>
    attempt(() => client.call('replayChange', { ...change, id: replay.value?.id ?? '' })),
  );

  provide(LIVE_PLAY, {
    replay,
    problem,
    publishers,
    refusal: computed(() => {
      if (recording.value === undefined) return 'Upload the file to the master first.';
      return mayReplay.value ? undefined : 'Participants and admins can play into live topics.';
    }),
    async start(choice, names) {
      const { player, timeMs } = local;
      const request = liveRequest(choice, recording.value?.id ?? '', player.value);
      const reply = await attempt(() =>
        client.call('replayStart', { ...request, clientId: client.id }),
      );
      if (reply === undefined) {
        const refused = problem.value;
        problem.value = undefined;
        return refused;
      }
      publishers.value = names;
      const shiftMs = (local.recording.value?.startMs ?? 0) - reply.recordingStartedMs;
      started.value = reply;
      control.change({
        seek: { positionMs: Math.max(0, timeMs.value + shiftMs) },
        action: ReplayAction.REPLAY_ACTION_PLAY,
      });
      return undefined;
    },
    resume() {
      leftId.value = undefined;
      return replay.value !== undefined;
    },
    async stop() {
      const { id } = replay.value ?? {};
      if (id === undefined) return;
      leftId.value = id;
      await attempt(() => client.call('replayStop', { id }));
    },
  });
  return createFollowedPlayer(local, {
    replay,
    change: (change) => control.change(change),
    isBusy: () => control.isBusy,
  });
}

/** Ghosts and sessions that run again have a playhead each. */
function isReplayOf(replay: Replay, recordingId: string | undefined): boolean {
  return replay.recordingId === recordingId && !replay.isGhost && replay.session === undefined;
}
