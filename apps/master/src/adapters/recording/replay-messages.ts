import type { RecordedDevice, RecordedSession, Span } from '@ubii/recording';

import type {
  PlayedBatch,
  PlayedPart,
  PlayerCommand,
  PlayerState,
  ReplayFacts,
} from '../../core/ports/index.ts';

/** What the thread starts with. */
export interface ReplayThreadData {
  /** Path of the folder of the recordings. */
  readonly folder: string;
}

/** What is called of the thread. Files and players have numbers. */
export interface ReplayThread {
  open(file: number, recordingId: string): Promise<ReplayFacts>;
  session(file: number, id: string, timeNs: bigint): Promise<RecordedSession | undefined>;
  devices(file: number, span: Span): Promise<readonly RecordedDevice[]>;
  play(file: number, player: number, part: PlayedPart): Promise<void>;
  do(player: number, command: PlayerCommand): Promise<void>;
  closePlayer(player: number): Promise<void>;
  close(file: number): Promise<void>;
}

/** What the thread calls. */
export interface ReplayOwner {
  /** Resolves when the batch is published. */
  publish(player: number, batch: PlayedBatch): Promise<void>;
  showState(player: number, state: PlayerState): void;
}
