import type { PersonalLabel } from '@ubii/proto';
import type { RecordingActivity } from '@ubii/recording';
import type { ReadableFile } from '../files/readable-file.ts';
import type { Span } from '../timeline/span.ts';
import type { Survey } from '../timeline/survey.ts';
import type { TileRequest } from '../timeline/tile-store.ts';
import type { Tile } from '../timeline/tile.ts';
import type { RecordedTopic } from '../timeline/track.ts';

/** A marker on the timeline, milliseconds since the beginning. */
export interface PlacedMarker {
  readonly id: string;
  readonly timeMs: number;
  readonly text: string;
  readonly author: string;
}

/** Where records are missing, milliseconds since the beginning. */
export interface PlacedGap extends Span {
  /** Undefined for all topics. */
  readonly topic: string | undefined;
  readonly records: number;
  readonly reason: string;
}

/** What a page knows of a recording that it opened. */
export interface OpenedRecording {
  readonly name: string;
  readonly notes: string;
  readonly masterName: string;
  /** Milliseconds since the Unix epoch. */
  readonly startMs: number;
  readonly durationMs: number;
  readonly records: number;
  readonly topics: readonly RecordedTopic[];
  /** Names of clients by id. */
  readonly clientNames: ReadonlyMap<string, string>;
  readonly markers: readonly PlacedMarker[];
  readonly gaps: readonly PlacedGap[];
  readonly isDamaged: boolean;
  /** Labels of personal data when it was recorded. */
  readonly labels: readonly PersonalLabel[];
}

/** What the player does, milliseconds since the beginning. */
export interface PlayerState {
  readonly status: 'paused' | 'playing' | 'ended';
  readonly timeMs: number;
  readonly rate: number;
  readonly loop: Span | undefined;
  readonly isBuffering: boolean;
}

/** The value of a topic at the playhead, encoded. */
export interface PlayedValue {
  readonly topic: string;
  readonly timeMs: number;
  readonly record: Uint8Array;
}

/** A session as it was at the playhead; before its start as it started, after its end as it ended. */
export interface PlayedSession {
  readonly id: string;
  readonly name: string;
  readonly state: string;
  /** The session as JSON. */
  readonly session: string;
  readonly presence: 'present' | 'starts' | 'ended';
  /** Since when it is as it is, or when it starts, milliseconds since the beginning. */
  readonly sinceMs: number;
}

/** What the page asks of the worker that reads a recording. */
export type RecordingCommand =
  | { readonly kind: 'open'; readonly source: ReadableFile }
  /** The file was changed: markers, or the name. */
  | { readonly kind: 'reopen' }
  | { readonly kind: 'tiles'; readonly request: TileRequest }
  | { readonly kind: 'frame'; readonly topic: string; readonly timeMs: number }
  | { readonly kind: 'play' }
  | { readonly kind: 'pause' }
  | { readonly kind: 'rate'; readonly rate: number }
  | { readonly kind: 'loop'; readonly loop: Span | undefined }
  | { readonly kind: 'seek'; readonly timeMs: number }
  | { readonly kind: 'stepRecord'; readonly topic: string; readonly direction: 1 | -1 }
  | { readonly kind: 'stepTime'; readonly deltaMs: number };

/** What the worker says. */
export type RecordingReport =
  | { readonly kind: 'opened'; readonly recording: OpenedRecording }
  | { readonly kind: 'failed'; readonly message: string }
  /** How many records came when, before any is read. */
  | { readonly kind: 'activity'; readonly activity: RecordingActivity }
  | { readonly kind: 'survey'; readonly survey: Survey }
  /** The largest error of a clock in it, milliseconds. */
  | { readonly kind: 'clocks'; readonly errorMs: number }
  | {
      readonly kind: 'tile';
      readonly topic: string;
      readonly level: number;
      readonly index: number;
      readonly tile: Tile;
    }
  | {
      readonly kind: 'frame';
      readonly topic: string;
      readonly timeMs: number;
      /** Undefined when it cannot be decoded. */
      readonly picture: ImageBitmap | undefined;
    }
  | { readonly kind: 'player'; readonly player: PlayerState }
  /** @remarks `isAll`: topics that are not in it have no value there */
  | { readonly kind: 'values'; readonly isAll: boolean; readonly values: readonly PlayedValue[] }
  | { readonly kind: 'sessions'; readonly sessions: readonly PlayedSession[] };
