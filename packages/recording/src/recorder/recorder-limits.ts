import type { TextLimits } from '@ubii/proto';

/** Limits that the recorder itself watches, by the names that they have on a master. */
export interface RecorderLimits extends TextLimits {
  readonly recordingsBytes: number;
  readonly markersPerRecording: number;
}
