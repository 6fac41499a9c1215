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

/** What the page calls of the worker that reads a recording. */
export interface RecordingWorker {
  /** Reads a file; resolves when all of it was read. The page learns what is in it bit by bit. */
  open(source: ReadableFile): Promise<void>;
  /** Reads the file again, which was changed: its markers, or its name. */
  reopen(): Promise<void>;
  /** A request replaces the one before of the same viewer. */
  readTiles(request: TileRequest): Promise<void>;
  /** @returns undefined when the picture cannot be decoded */
  readFrame(topic: string, timeMs: number): Promise<ImageBitmap | undefined>;
  play(): Promise<void>;
  pause(): Promise<void>;
  setRate(rate: number): Promise<void>;
  setLoop(loop: Span | undefined): Promise<void>;
  seek(timeMs: number): Promise<void>;
  stepRecord(topic: string, direction: 1 | -1): Promise<void>;
  stepTime(deltaMs: number): Promise<void>;
}

/** What the worker calls of the page. */
export interface RecordingPage {
  showOpened(recording: OpenedRecording): void;
  /** Playback failed. */
  showFailure(message: string): void;
  /** How many records came when, before any is read. */
  showActivity(activity: RecordingActivity): void;
  showSurvey(survey: Survey): void;
  /** @param errorMs the largest error of a clock in it, milliseconds */
  showClocks(errorMs: number): void;
  showTile(topic: string, level: number, index: number, tile: Tile): void;
  showPlayer(player: PlayerState): void;
  /** @param isAll topics that are not in `values` have no value there */
  showValues(values: readonly PlayedValue[], isAll: boolean): void;
  showSessions(sessions: readonly PlayedSession[]): void;
}
