import type { Recording } from '@ubii/proto';
import type { ReadableFile } from '../files/readable-file.ts';
import type { OpenedPlayer } from '../opened/opened-player.ts';
import type { Span } from '../timeline/span.ts';

/** What is exported. */
export interface ExportTarget {
  /** Undefined: no span is marked. */
  readonly span?: Span | undefined;
  readonly opened: Pick<OpenedPlayer, 'recording'>;
  /** At the master; undefined for a file of this device. */
  readonly recording: Recording | undefined;
  readonly source: ReadableFile;
}
