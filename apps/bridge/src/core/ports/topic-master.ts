import type { DataFormat } from '@ubii/proto';

/** A record of the master, encoded. */
export interface MasterRecord {
  readonly topic: string;
  readonly bytes: Uint8Array;
  /** Client that published it; empty if the record does not name it. */
  readonly publisherId: string;
}

/** Takes the records of a subscription. */
export interface MasterListener {
  onRecord(record: MasterRecord): void;
  /** The topic has no value any more. [TD-42] */
  onGone(topic: string): void;
}

/** The topics of the master. */
export interface TopicMaster {
  /** Id of the bridge as a client; empty before the first connection. */
  readonly ownId: string;
  publish(topic: string, format: DataFormat, value: unknown, timestampMs: number | undefined): void;
  endTopic(topic: string): void;
  /** @returns ends the subscription */
  subscribe(
    pattern: { readonly topic: string } | { readonly glob: string },
    listener: MasterListener,
  ): () => void;
}
