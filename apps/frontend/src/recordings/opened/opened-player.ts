import type { RecordingActivity } from '@ubii/recording';
import { callWorker, type WorkerPeer } from '@ubii/worker-rpc/browser';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { perFrame } from '../../connection/per-frame.ts';
import type { ReadableFile } from '../files/readable-file.ts';
import { FrameCache } from '../timeline/frame-cache.ts';
import type { Span } from '../timeline/span.ts';
import type { Survey } from '../timeline/survey.ts';
import { TileStore } from '../timeline/tile-store.ts';
import type {
  OpenedRecording,
  PlayedSession,
  PlayerState,
  RecordingPage,
  RecordingWorker,
} from '../reading/recording-messages.ts';
import { PlayedValues } from './played-values.ts';

/** A recording that a page opened, at its playhead. */
export interface OpenedPlayer {
  /** Undefined until it is open. */
  readonly recording: Readonly<ShallowRef<OpenedRecording | undefined>>;
  /** Why it cannot be read. */
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  /** How many records came when. */
  readonly activity: Readonly<ShallowRef<RecordingActivity | undefined>>;
  readonly survey: Readonly<ShallowRef<Survey | undefined>>;
  /** The largest error of a clock in it, milliseconds; undefined until it is known, and when no clock was measured. */
  readonly clockErrorMs: Readonly<ShallowRef<number | undefined>>;
  readonly player: Readonly<ShallowRef<PlayerState>>;
  /** Where the playhead is: where it was dragged to, as soon as it is dragged. */
  readonly timeMs: ComputedRef<number>;
  readonly values: PlayedValues;
  readonly sessions: Readonly<ShallowRef<readonly PlayedSession[]>>;
  readonly tiles: TileStore;
  readonly frames: FrameCache<ImageBitmap>;
  /** Counts up when tiles or pictures came. */
  readonly drawn: Readonly<ShallowRef<number>>;
  /** Reads the file again, which was changed. */
  reopen(): void;
  togglePlay(): void;
  setPlaying(isPlaying: boolean): void;
  seek(timeMs: number): void;
  setRate(rate: number): void;
  setLoop(loop: Span | undefined): void;
  stepRecord(topic: string, direction: 1 | -1): void;
  stepTime(deltaMs: number): void;
  close(): void;
}

const AT_START: PlayerState = {
  status: 'paused',
  timeMs: 0,
  rate: 1,
  loop: undefined,
  isBuffering: false,
};
/** The playhead has come where it was wished, milliseconds. */
const ARRIVED_MS = 0.5;

/** Interval of updates of values during playback, milliseconds: faster ones cannot be read, and each draws the graph. */
const SHOW_EVERY_MS = 50;

/** Starts the worker that reads a recording. */
export type OpenRecordingWorker = (page: RecordingPage) => WorkerPeer<RecordingWorker>;

const openRecordingWorker: OpenRecordingWorker = (page) =>
  callWorker(
    new Worker(new URL('../reading/recording-worker.ts', import.meta.url), { type: 'module' }),
    page,
    'This browser cannot read the recording.',
  );

/**
 * @param atFrame calls once before the next frame
 * @param nowMs any clock
 */
export function createOpenedPlayer(
  source: ReadableFile,
  atFrame?: (fn: () => void) => void,
  nowMs = (): number => performance.now(),
  openWorker = openRecordingWorker,
): OpenedPlayer {
  const recording = shallowRef<OpenedRecording>();
  const failure = shallowRef<string>();
  const activity = shallowRef<RecordingActivity>();
  const survey = shallowRef<Survey>();
  const clockErrorMs = shallowRef<number>();
  const player = shallowRef(AT_START);
  const sessions = shallowRef<readonly PlayedSession[]>([]);
  const drawn = shallowRef(0);
  const wishedMs = shallowRef<number>();
  const values = new PlayedValues();
  const tiles = new TileStore((request) => run(calls.readTiles(request)));
  const frames = new FrameCache<ImageBitmap>(
    (topic, timeMs) => run(readFrame(topic, timeMs)),
    (picture) => picture.close(),
  );
  const draw = perFrame(() => (drawn.value += 1), atFrame);
  let shownMs = -Infinity;
  const showValues = perFrame(() => {
    shownMs = nowMs();
    values.show();
  }, atFrame);

  const worker = openWorker({
    showOpened(opened) {
      recording.value = opened;
      failure.value = undefined;
    },
    showFailure: (message) => void (failure.value = message),
    showActivity: (counts) => void (activity.value = counts),
    showSurvey(read) {
      survey.value = read;
      tiles.setWhole(new Map(read.tracks.map(({ topic, tile }) => [topic, tile])));
      draw();
    },
    showClocks: (errorMs) => void (clockErrorMs.value = errorMs),
    showTile(topic, level, index, tile) {
      tiles.take(topic, level, index, tile);
      draw();
    },
    showValues(read, isAll) {
      values.add(read, isAll);
      if (isAll || nowMs() - shownMs >= SHOW_EVERY_MS) showValues();
    },
    showSessions: (near) => void (sessions.value = near),
    showPlayer(state) {
      player.value = state;
      if (state.status !== 'playing') showValues();
      if (Math.abs(state.timeMs - (wishedMs.value ?? Infinity)) < ARRIVED_MS)
        wishedMs.value = undefined;
    },
  });
  const { calls } = worker;
  function run(call: Promise<void>): void {
    call.catch((error: Error) => (failure.value = error.message));
  }
  async function readFrame(topic: string, timeMs: number): Promise<void> {
    frames.take(topic, timeMs, await calls.readFrame(topic, timeMs));
    draw();
  }
  const setPlaying = (isPlaying: boolean): void => run(isPlaying ? calls.play() : calls.pause());
  run(calls.open(source));

  const clamp = (timeMs: number): number =>
    Math.min(Math.max(0, timeMs), recording.value?.durationMs ?? 0);

  return {
    recording,
    failure,
    activity,
    survey,
    clockErrorMs,
    player,
    values,
    sessions,
    tiles,
    frames,
    drawn,
    timeMs: computed(() => wishedMs.value ?? player.value.timeMs),
    reopen: () => run(calls.reopen()),
    togglePlay: () => setPlaying(player.value.status !== 'playing'),
    setPlaying,
    seek(timeMs) {
      wishedMs.value = clamp(timeMs);
      run(calls.seek(wishedMs.value));
    },
    setRate: (rate) => run(calls.setRate(rate)),
    setLoop: (loop) => run(calls.setLoop(loop)),
    stepRecord: (topic, direction) => run(calls.stepRecord(topic, direction)),
    stepTime: (deltaMs) => run(calls.stepTime(deltaMs)),
    close() {
      frames.close();
      worker.close();
    },
  };
}
