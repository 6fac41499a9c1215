import type { Clock } from '@ubii/timing';
import type { RecordsReader } from '../reading/recording-reader.ts';
import type { RecordedRecord } from '../records/recorded-record.ts';

/** A span of a recording, nanoseconds since the Unix epoch. */
export interface Span {
  readonly fromNs: bigint;
  readonly untilNs: bigint;
}

/** What a playback does. */
export interface PlaybackState {
  readonly status: 'paused' | 'playing' | 'ended';
  readonly positionNs: bigint;
  /** 0.1 to 10. */
  readonly rate: number;
  readonly loop: Span | undefined;
  /** Waits for the source. */
  readonly isBuffering: boolean;
}

/** Where records go. */
export interface PlaybackSink {
  /** Records that are due, in order. */
  onRecords(records: readonly RecordedRecord[]): void;
  /** The playhead jumped: the last record of each topic at the new moment. Topics that are not in it have no value there. */
  onSeek(latest: ReadonlyMap<string, RecordedRecord>, positionNs: bigint): void;
  /** Status, rate, loop, buffering or position changed. While playing, position changes with each tick. */
  onState(state: PlaybackState): void;
  /** The source failed; playback is paused. */
  onError(error: unknown): void;
}

/** Options of a playback. */
export interface PlaybackOptions {
  readonly clock: Clock;
  readonly reader: RecordsReader;
  readonly sink: PlaybackSink;
  /** Time between two ticks, milliseconds. @default 16 */
  readonly tickMs?: number;
}

/** Plays a recording. Begins paused at the start, and has emitted nothing then: call `seek` to get the first values. */
export declare class Playback {
  constructor(options: PlaybackOptions);
  get state(): PlaybackState;
  /** Goes on; from the start (of the loop) when the end was reached. */
  play(): void;
  pause(): void;
  /** @param rate is limited to 0.1 … 10 */
  setRate(rate: number): void;
  /** Plays this span again and again; undefined ends that. */
  setLoop(loop: Span | undefined): void;
  /** Jumps and emits the last value of every topic. While one seek runs, only the newest of further ones is kept. */
  seek(positionNs: bigint): Promise<void>;
  /** Pauses and jumps to the next or the previous moment at which the topic has a record; does nothing when there is none. */
  stepRecord(topic: string, direction: 1 | -1): Promise<void>;
  /** Pauses and jumps by a time. @param deltaMs may be negative */
  stepTime(deltaMs: number): Promise<void>;
  /** Ends timers and reading. */
  close(): void;
}
