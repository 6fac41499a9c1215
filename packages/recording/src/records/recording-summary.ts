import type { Gap, Marker, RecordedClient } from './recording-event.ts';
import type { RecordingHeader } from './recording-header.ts';

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

/** Records of one topic by one publisher. */
export interface RecordedTopic {
  readonly topic: string;
  /** Client id of the publisher; empty for the master and in files of other programs. */
  readonly clientId: string;
  /** Name that the client had when it first published; empty when not known. */
  readonly clientName: string;
  /** Data format of the first value, such as `vector2`; empty for a record without value and for raw messages. */
  readonly format: string;
  readonly records: number;
  /** Messages of another program, which are not `TopicDataRecord`s. */
  readonly isRaw: boolean;
  /** Name of the MCAP schema, `ubii.topicData.TopicDataRecord` unless raw. */
  readonly schemaName: string;
  /** Such as `protobuf`, `json`, `cdr`. */
  readonly messageEncoding: string;
}

/** What is known of a recording when it is opened. */
export interface RecordingSummary extends RecordingHeader {
  /** Time of the first record, and of the last record or marker, nanoseconds since the Unix epoch; 0 without any. */
  readonly startNs: bigint;
  readonly endNs: bigint;
  readonly records: number;
  readonly topics: readonly RecordedTopic[];
  /** By time; without those that were deleted. */
  readonly markers: readonly Marker[];
  /** The last state of each client. */
  readonly clients: readonly RecordedClient[];
  readonly gaps: readonly Gap[];
  /** Attachments and metadata of other programs, which cuts copy. */
  readonly foreignParts: ForeignParts;
  /** The file was not written by Ubi-Interact. */
  readonly isForeign: boolean;
  /** The end of the file is missing: it was read up to the last whole chunk. */
  readonly isDamaged: boolean;
}
