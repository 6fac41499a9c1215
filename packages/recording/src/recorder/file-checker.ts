import type { Recording } from '@ubii/proto';
import type { FileFacts } from './file-facts.ts';
import type { RecordingJob } from './recorder.ts';

/** A file to check. */
export interface CheckJob {
  readonly id: string;
  /** The file is an upload of this id, which becomes a recording. @default it is a file of the folder */
  readonly upload?: { readonly job: RecordingJob; readonly nowMs: number };
}

/** A file as the list has it. */
export interface ListedFile {
  readonly facts: Pick<FileFacts, 'makerId'>;
  readonly recording: Recording;
}

/** What a check found. */
export type Verdict =
  | { readonly kind: 'accepted'; readonly file: ListedFile }
  /** It is no recording that can be read. @param reason a sentence */
  | { readonly kind: 'refused'; readonly reason: string }
  /** The check of it did not come to an end, as with too little memory. @param reason a sentence */
  | { readonly kind: 'unchecked'; readonly reason: string };

/** Checks files that others wrote, before anything else reads them. [RC-44] */
export interface FileChecker {
  /** Repairs and reads a file. @throws ServiceError when no file can be checked now; the error of the disk */
  check(job: CheckJob): Promise<Verdict>;
  close(): Promise<void>;
}
