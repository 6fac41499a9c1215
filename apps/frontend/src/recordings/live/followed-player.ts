import { ReplayAction, ReplayState, type Replay } from '@ubii/proto';
import { watch, type Ref } from 'vue';
import type { OpenedPlayer } from '../opened/opened-player.ts';
import type { PlayerState } from '../reading/recording-messages.ts';
import type { Span } from '../timeline/span.ts';
import type { ReplayChange } from './replay-control.ts';

/** The replay that a page follows and controls. */
export interface FollowedReplay {
  /** Undefined while the recording is played on this page only. */
  readonly replay: Readonly<Ref<Replay | undefined>>;
  change(change: ReplayChange): void;
  /** Whether a change is on its way. */
  isBusy(): boolean;
}

/** Apart by less, both play the same moment, milliseconds of the clock. */
const TOLERANCE_MS = 300;
/** The same while both are paused. */
const PAUSED_TOLERANCE_MS = 1;

/**
 * A player whose page follows a replay of the same recording, and controls it. What people do is done on the page at once, and
 * sent; what others do to the replay is done on the page with the next news.
 */
export function createFollowedPlayer(local: OpenedPlayer, followed: FollowedReplay): OpenedPlayer {
  const { replay } = followed;
  const isLive = (): boolean => replay.value !== undefined;
  /** Start of the file on this page minus start of the recording at the master, milliseconds. */
  const shiftMs = (of: Replay): number =>
    (local.recording.value?.startMs ?? of.recordingStartedMs) - of.recordingStartedMs;
  const toMaster = (timeMs: number): number =>
    replay.value ? Math.max(0, timeMs + shiftMs(replay.value)) : timeMs;
  const send = (change: () => ReplayChange): void => {
    if (isLive()) followed.change(change());
  };
  const sendSeek = (timeMs: number): void =>
    send(() => ({ seek: { positionMs: toMaster(timeMs) } }));

  // The worker knows where a step leads, so it is sent when the playhead has arrived there.
  let isStepping = false;
  const step = (run: () => void): void => {
    isStepping = isLive();
    send(() => ({ action: ReplayAction.REPLAY_ACTION_PAUSE }));
    run();
  };
  watch(local.player, (now, before) => {
    if (!isStepping || now.status === 'playing' || now.timeMs === before.timeMs) return;
    isStepping = false;
    sendSeek(now.timeMs);
  });
  watch(
    replay,
    (now) => {
      if (now && !followed.isBusy() && !isStepping) follow(local, now, shiftMs(now));
    },
    { immediate: true },
  );

  return {
    ...local,
    togglePlay() {
      const isPlaying = local.player.value.status === 'playing';
      local.togglePlay();
      send(() => ({ action: actionOf(!isPlaying) }));
    },
    setPlaying(isPlaying) {
      local.setPlaying(isPlaying);
      send(() => ({ action: actionOf(isPlaying) }));
    },
    seek(timeMs) {
      local.seek(timeMs);
      sendSeek(local.timeMs.value);
    },
    setRate(rate) {
      local.setRate(rate);
      send(() => ({ rate }));
    },
    setLoop(loop) {
      local.setLoop(loop);
      const span = loop && { fromMs: toMaster(loop.fromMs), untilMs: toMaster(loop.untilMs) };
      send(() => ({ loop: { isLooping: span !== undefined, ...(span && { span }) } }));
    },
    stepRecord: (topic, direction) => step(() => local.stepRecord(topic, direction)),
    stepTime: (deltaMs) => step(() => local.stepTime(deltaMs)),
  };
}

const actionOf = (isPlaying: boolean): ReplayAction =>
  isPlaying ? ReplayAction.REPLAY_ACTION_PLAY : ReplayAction.REPLAY_ACTION_PAUSE;

/** Brings the page to where the replay is. */
function follow(local: OpenedPlayer, replay: Replay, shiftMs: number): void {
  const player = local.player.value;
  const isPlaying = replay.state === ReplayState.REPLAY_STATE_PLAYING;
  if (player.rate !== replay.rate) local.setRate(replay.rate);
  const loop = loopOf(replay, shiftMs);
  if (!isSameLoop(player.loop, loop)) local.setLoop(loop);
  const timeMs = replay.positionMs - shiftMs;
  const tolerance = isPlaying ? TOLERANCE_MS * Math.max(1, replay.rate) : PAUSED_TOLERANCE_MS;
  if (Math.abs(local.timeMs.value - timeMs) > tolerance) local.seek(timeMs);
  if (isPlaying !== (player.status === 'playing')) local.setPlaying(isPlaying);
}

function loopOf({ isLooping, span }: Replay, shiftMs: number): Span | undefined {
  if (!isLooping || span === undefined) return undefined;
  return { fromMs: Math.max(0, span.fromMs - shiftMs), untilMs: span.untilMs - shiftMs };
}

function isSameLoop(a: PlayerState['loop'], b: Span | undefined): boolean {
  if (a === undefined || b === undefined) return a === b;
  return Math.abs(a.fromMs - b.fromMs) < 1 && Math.abs(a.untilMs - b.untilMs) < 1;
}
