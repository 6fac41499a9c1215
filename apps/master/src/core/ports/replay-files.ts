import type { RecordedDevice, RecordedSession, RecordedTopic, Span } from '@ubii/recording';

/** A finished recording, as far as replays need to know it. */
export interface ReplayFacts {
  /** Time of the first and the last record, nanoseconds since the Unix epoch. */
  readonly startNs: bigint;
  readonly endNs: bigint;
  readonly topics: readonly RecordedTopic[];
}

/** What one player plays. */
export interface PlayedPart {
  /** Recorded topics with the names under which they are published. */
  readonly topics: readonly (readonly [recorded: string, played: string])[];
  /** Client id for records that state one; undefined: as recorded. */
  readonly clientId: string | undefined;
  /** False: timestamps become the time at which the record is published. */
  readonly keepsTimestamps: boolean;
  /** Bytes that are read ahead. */
  readonly readAheadBytes: number;
}

/** Commands for a player. */
export type PlayerCommand =
  | { readonly kind: 'rate'; readonly rate: number }
  | { readonly kind: 'span'; readonly span: Span; readonly isLooping: boolean }
  | { readonly kind: 'seek'; readonly positionNs: bigint }
  /** Pauses, and steps by moments with records; negative: back. */
  | { readonly kind: 'step'; readonly moments: number }
  | { readonly kind: 'play' }
  | { readonly kind: 'pause' };

/** Records that are due. */
export interface PlayedBatch {
  /** Encoded `TopicData` with the records. */
  readonly frame: Uint8Array;
  /** Number of the records. */
  readonly records: number;
  /** Played topics among them that no earlier batch had. */
  readonly newTopics: readonly string[];
}

/** What a player does. */
export interface PlayerState {
  readonly status: 'playing' | 'paused' | 'ended';
  /** Nanoseconds since the Unix epoch. */
  readonly positionNs: bigint;
  /** Why it cannot go on, one sentence; empty when it can. */
  readonly problem: string;
}

/** Where a player puts what it plays. */
export interface PlayerSink {
  /** Publishes a batch. The player waits while several batches are not published yet. */
  onBatch(batch: PlayedBatch): Promise<void>;
  /** Called when the status or the problem changes, and about five times a second while it plays. */
  onState(state: PlayerState): void;
  /** The player is gone, with its file. */
  onLost(reason: string): void;
}

/** Plays a recording. Begins paused, and has published nothing then. */
export interface ReplayPlayer {
  /** Resolves when it is done and what it played at once is published. @throws ServiceError when the player is gone */
  do(command: PlayerCommand): Promise<void>;
  /** Ends reading. No batch comes afterwards. */
  close(): void;
}

/** An open recording. */
export interface ReplayFile {
  readonly facts: ReplayFacts;
  /** Returns a session as it was at a moment, or when it was first there. @param timeNs nanoseconds since the Unix epoch */
  session(id: string, timeNs: bigint): Promise<RecordedSession | undefined>;
  /** Returns the devices that were registered at any time in a span, each version once; the first of them when there are too many. */
  devices(span: Span): Promise<readonly RecordedDevice[]>;
  play(part: PlayedPart, sink: PlayerSink): ReplayPlayer;
  /** Closes its players and the file. */
  close(): Promise<void>;
}

/** Opens finished recordings to be played. [RP-15] */
export interface ReplayFiles {
  /** @throws ServiceError when there is none of this id, or it cannot be read */
  open(recordingId: string): Promise<ReplayFile>;
  /** Closes all. */
  close(): Promise<void>;
}
