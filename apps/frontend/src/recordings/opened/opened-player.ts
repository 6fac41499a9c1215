import type { RecordingActivity } from '@ubii/recording';
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
  RecordingReport,
} from '../reading/recording-messages.ts';
import { PlayedValues } from './played-values.ts';
import type { RecordingPort } from './recording-port.ts';

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

/**
 * @param atFrame calls once before the next frame
 * @param nowMs any clock
 */
export function createOpenedPlayer(
  port: RecordingPort,
  source: ReadableFile,
  atFrame?: (fn: () => void) => void,
  nowMs = (): number => performance.now(),
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
  const tiles = new TileStore((request) => port.send({ kind: 'tiles', request }));
  const frames = new FrameCache<ImageBitmap>(
    (topic, timeMs) => port.send({ kind: 'frame', topic, timeMs }),
    (picture) => picture.close(),
  );
  const draw = perFrame(() => (drawn.value += 1), atFrame);
  let shownMs = -Infinity;
  const showValues = perFrame(() => {
    shownMs = nowMs();
    values.show();
  }, atFrame);

  function handle(report: RecordingReport): void {
    switch (report.kind) {
      case 'opened':
        recording.value = report.recording;
        failure.value = undefined;
        return;
      case 'failed':
        failure.value = report.message;
        return;
      case 'activity':
        activity.value = report.activity;
        return;
      case 'survey':
        survey.value = report.survey;
        tiles.setWhole(new Map(report.survey.tracks.map(({ topic, tile }) => [topic, tile])));
        return draw();
      case 'clocks':
        clockErrorMs.value = report.errorMs;
        return;
      case 'tile':
        tiles.take(report.topic, report.level, report.index, report.tile);
        return draw();
      case 'frame':
        frames.take(report.topic, report.timeMs, report.picture);
        return draw();
      case 'values':
        values.add(report.values, report.isAll);
        if (report.isAll || nowMs() - shownMs >= SHOW_EVERY_MS) showValues();
        return;
      case 'sessions':
        sessions.value = report.sessions;
        return;
      case 'player':
        player.value = report.player;
        if (report.player.status !== 'playing') showValues();
        if (Math.abs(report.player.timeMs - (wishedMs.value ?? Infinity)) < ARRIVED_MS)
          wishedMs.value = undefined;
    }
  }
  port.onReport(handle);
  port.send({ kind: 'open', source });

  const clamp = (timeMs: number): number =>
    Math.min(Math.max(0, timeMs), recording.value?.durationMs ?? 0);

  return {
    ...{ recording, failure, activity, survey, clockErrorMs, player, values, sessions, tiles },
    ...{ frames, drawn },
    timeMs: computed(() => wishedMs.value ?? player.value.timeMs),
    reopen: () => port.send({ kind: 'reopen' }),
    togglePlay: () => port.send({ kind: player.value.status === 'playing' ? 'pause' : 'play' }),
    setPlaying: (isPlaying) => port.send({ kind: isPlaying ? 'play' : 'pause' }),
    seek(timeMs) {
      wishedMs.value = clamp(timeMs);
      port.send({ kind: 'seek', timeMs: wishedMs.value });
    },
    setRate: (rate) => port.send({ kind: 'rate', rate }),
    setLoop: (loop) => port.send({ kind: 'loop', loop }),
    stepRecord: (topic, direction) => port.send({ kind: 'stepRecord', topic, direction }),
    stepTime: (deltaMs) => port.send({ kind: 'stepTime', deltaMs }),
    close() {
      frames.close();
      port.close();
    },
  };
}
