/** Where a recording comes from. */
export type RecordingKind = 'recording' | 'flight-recorder' | 'import';

/** The metadata record `ubi-interact` of a file. The last one of a file is valid. */
export interface RecordingHeader {
  readonly name: string;
  readonly kind: RecordingKind;
  readonly masterName: string;
  /** Version of the program that wrote the file. */
  readonly version: string;
  readonly notes: string;
  /** What was chosen to be recorded, as JSON. */
  readonly selection: string;
}
