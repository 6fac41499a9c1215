import type { CheckJob, Verdict } from '../recorder/file-checker.ts';

/** Limits of the process that checks files; see `LIMITS` of the master. [RC-44] */
export interface CheckLimits {
  /** For an upload; files of the folder get more by their size, because their repair reads all of them. */
  readonly recordingCheckMs: number;
  /** Heap of the process. */
  readonly recordingCheckBytes: number;
}

/** From the process that checks files. */
export type FromChecker =
  | { readonly kind: 'ready' }
  | { readonly kind: 'verdict'; readonly verdict: Verdict }
  /** An error of the disk: it says nothing about the file. */
  | { readonly kind: 'failure'; readonly reason: string };

/** To the process. */
export type ToChecker = CheckJob;
