import type { ReadableFile } from '../files/readable-file.ts';
import type { PersonalChoice } from '../personal/personal-choice.ts';

/** What a recording is written as. */
export type ExportFormat = 'csv' | 'parquet' | 'xdf' | 'mcap' | 'video';

/** What of a recording is exported. */
export interface ExportRequest {
  readonly format: ExportFormat;
  readonly topics: readonly string[];
  /** Milliseconds since the beginning; undefined for all of it. */
  readonly span: { readonly fromMs: number; readonly untilMs: number } | undefined;
  /** Name of the recording. */
  readonly name: string;
  /** How personal data is replaced; undefined to keep it. */
  readonly personal?: PersonalChoice | undefined;
}

/** What the page calls of the worker that exports. */
export interface ExportWorker {
  /** @param handle where the file is written to; undefined to keep it in memory */
  run(
    source: ReadableFile,
    request: ExportRequest,
    handle: FileSystemFileHandle | undefined,
  ): Promise<ExportedFile>;
  cancel(): Promise<void>;
}

export interface ExportedFile {
  /** Undefined when it was written to the handle. */
  readonly file: Blob | undefined;
  /** With what was found of labelled values, as sentences without their ends. */
  readonly leftOut: readonly string[];
  /** Content of the key file, when personal data was replaced. */
  readonly key: string | undefined;
}

/** What the worker calls of the page. */
export interface ExportPage {
  /** @param share 0 to 1 */
  showProgress(share: number): void;
}
