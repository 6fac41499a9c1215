/** A file that another program put beside the messages of a recording. */
export interface AttachedFile {
  readonly name: string;
  /** Such as `image/jpeg`; empty when not known. */
  readonly mediaType: string;
  readonly sizeBytes: number;
  /** Nanoseconds since the Unix epoch. */
  readonly logTimeNs: bigint;
}

/** What other programs put beside the messages of a recording. */
export interface ForeignParts {
  readonly attachments: readonly AttachedFile[];
  /** Names of their metadata, each as often as it is there. */
  readonly metadata: readonly string[];
}
