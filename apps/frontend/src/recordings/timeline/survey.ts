import type { TopicRecord } from '@ubii/proto';
import { RunLog, type Run } from './run-log.ts';
import { entryOf, trackKind, type TrackKind } from './track-entry.ts';
import { TileBuilder, type Tile } from './tile.ts';

/** Buckets of the whole recording: several for each pixel of a wide view of all of it. */
const SURVEY_BUCKETS = 4096;
/** Bars of things and texts end when nothing came for this long, milliseconds. */
const THING_GAP_MS = 1000;
const LANES: Readonly<Record<TrackKind, number>> = {
  lines: 1,
  ticks: 1,
  frames: 1,
  text: 1,
  bytes: 1,
  bars: 4,
};
/** Times of pictures kept of a track. */
const MAX_FRAMES = 300_000;

/** What is known of one track over the whole recording. */
export interface SurveyedTrack {
  readonly topic: string;
  readonly tile: Tile;
  readonly runs: readonly Run[];
  /** When pictures came, milliseconds since the beginning. */
  readonly frames: Float64Array;
}

/** A recording as far as it was read. */
export interface Survey {
  readonly tracks: readonly SurveyedTrack[];
  /** How far it was read, milliseconds. */
  readonly readMs: number;
  readonly isWhole: boolean;
}

interface OpenTrack {
  readonly builder: TileBuilder;
  readonly runs: RunLog | undefined;
  readonly frames: number[] | undefined;
}

/** Reads a recording once from its beginning to its end, for the views of all of it. */
export class SurveyBuilder {
  readonly #durationMs: number;
  readonly #tracks = new Map<string, OpenTrack>();
  #readMs = 0;

  constructor(durationMs: number) {
    this.#durationMs = Math.max(1, durationMs);
  }

  /** @param record undefined when it cannot be decoded: it only counts */
  add(topic: string, timeMs: number, record: TopicRecord | undefined): void {
    this.#readMs = Math.max(this.#readMs, timeMs);
    const track = this.#trackOf(topic, trackKind(record?.format));
    const { numbers, states } = record ? entryOf(record) : { numbers: [], states: undefined };
    track.builder.add(timeMs, { numbers });
    if (states) track.runs?.add(timeMs, states);
  }

  /** Adds a picture, which is only counted. */
  addFrame(topic: string, timeMs: number): void {
    this.#readMs = Math.max(this.#readMs, timeMs);
    const track = this.#trackOf(topic, 'frames');
    track.builder.add(timeMs, { numbers: [] });
    if (track.frames && track.frames.length < MAX_FRAMES) track.frames.push(timeMs);
  }

  survey(isWhole: boolean): Survey {
    const readMs = isWhole ? this.#durationMs : this.#readMs;
    const tracks = [...this.#tracks].map(([topic, { builder, runs, frames }]) => ({
      topic,
      tile: builder.tile(isWhole),
      runs: runs?.runs(readMs) ?? [],
      frames: Float64Array.from(frames ?? []),
    }));
    return { tracks, readMs, isWhole };
  }

  #trackOf(topic: string, kind: TrackKind): OpenTrack {
    let track = this.#tracks.get(topic);
    if (track === undefined) this.#tracks.set(topic, (track = this.#openTrack(kind)));
    return track;
  }

  #openTrack(kind: TrackKind): OpenTrack {
    // The last record lies at the very end
    const bucketMs = (this.#durationMs * 1.0001) / SURVEY_BUCKETS;
    const hasRuns = kind === 'bars' || kind === 'text' || kind === 'ticks';
    return {
      builder: new TileBuilder({ fromMs: 0, bucketMs, buckets: SURVEY_BUCKETS }),
      runs: hasRuns
        ? new RunLog(LANES[kind], kind === 'bars' ? THING_GAP_MS : Infinity)
        : undefined,
      frames: kind === 'frames' ? [] : undefined,
    };
  }
}
