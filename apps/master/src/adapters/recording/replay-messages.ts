import type { ServiceErrorCode } from '@ubii/proto';
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

/** What is asked of the thread, and its answers. Files and players have numbers. */
export interface ThreadCalls {
  open(file: number, recordingId: string): Promise<ReplayFacts>;
  session(file: number, id: string, timeNs: bigint): Promise<RecordedSession | undefined>;
  devices(file: number, span: Span): Promise<readonly RecordedDevice[]>;
  play(file: number, player: number, part: PlayedPart): Promise<void>;
  do(player: number, command: PlayerCommand): Promise<void>;
  closePlayer(player: number): Promise<void>;
  close(file: number): Promise<void>;
}

export type ThreadMethod = keyof ThreadCalls;

/** To the thread. */
export type ToReplayThread =
  | {
      readonly kind: 'call';
      readonly id: number;
      readonly method: ThreadMethod;
      readonly args: readonly unknown[];
    }
  /** A batch of this player was published. */
  | { readonly kind: 'published'; readonly player: number };

/** From the thread. */
export type FromReplayThread =
  | { readonly kind: 'batch'; readonly player: number; readonly batch: PlayedBatch }
  | { readonly kind: 'state'; readonly player: number; readonly state: PlayerState }
  | { readonly kind: 'reply'; readonly id: number; readonly value: unknown }
  | {
      readonly kind: 'refusal';
      readonly id: number;
      readonly code: ServiceErrorCode;
      readonly message: string;
    };
