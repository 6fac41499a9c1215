import type { EventsReader } from '@ubii/recording';

/** What an export reads: a recording as it is, or as it is shared. */
export type ExportReader = EventsReader;
