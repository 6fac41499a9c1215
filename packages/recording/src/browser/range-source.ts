import type { RecordingSource } from '../storage/recording-storage.ts';

/** Reads a file from a server that answers requests for ranges. */
export declare class RangeSource implements RecordingSource {
  /** @param fetch sends the requests. @default the browser's */
  constructor(url: string, fetch?: typeof globalThis.fetch);
  size(): Promise<bigint>;
  read(offset: bigint, length: bigint): Promise<Uint8Array>;
}
