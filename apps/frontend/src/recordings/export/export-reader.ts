import type { RecordingReader } from '@ubii/recording';

/** What an export reads: a recording as it is, or as it is shared. */
export type ExportReader = Pick<
  RecordingReader,
  'summary' | 'records' | 'latestAt' | 'latestOfEachAt' | 'events' | 'clocks'
>;
