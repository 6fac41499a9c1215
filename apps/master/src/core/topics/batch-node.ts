import type { BatchEncoder, RecordBatch } from '../ports/record-batch.ts';
import type { TopicEntry } from './topic-entry.ts';

/**
 * A batch as the last node of a chain of records. Appending gives the next node and leaves this one as
 * it is. A node remembers the last node appended to it, so that subscribers that get the same
 * records walk the same chain and share every node, and with it the frame the adapter builds of it.
 */
export class BatchNode implements RecordBatch {
  readonly previous: BatchNode | undefined;
  /** The topic of `record`; undefined in the empty node that chains begin with. */
  readonly entry: TopicEntry | undefined;
  readonly record: Uint8Array | undefined;
  readonly isEvent: boolean;
  /** Of the record, as it was when it was appended: the topic may have another value by now. [CU-12] */
  readonly stamp: number;
  readonly publisherId: string;
  readonly count: number;
  readonly byteLength: number;
  #next: BatchNode | undefined = undefined;
  #records: readonly Uint8Array[] | undefined = undefined;
  #encoder: BatchEncoder<unknown> | undefined = undefined;
  #encoded: unknown = undefined;
  #otherEncoded: Map<BatchEncoder<unknown>, unknown> | undefined = undefined;

  private constructor(
    previous: BatchNode | undefined,
    entry: TopicEntry | undefined,
    record: Uint8Array | undefined,
    isEvent: boolean,
    stamp: number,
  ) {
    this.previous = previous;
    this.entry = entry;
    this.record = record;
    this.isEvent = isEvent;
    this.stamp = stamp;
    this.publisherId = entry?.publisherId ?? '';
    this.count = previous === undefined ? 0 : previous.count + 1;
    this.byteLength = (previous?.byteLength ?? 0) + (record?.byteLength ?? 0);
  }

  /** The empty node that a chain begins with. */
  static empty(): BatchNode {
    return new BatchNode(undefined, undefined, undefined, false, 0);
  }

  /** @param stamp of a record that waited. Default: that of the value of the topic */
  append(entry: TopicEntry, record: Uint8Array, isEvent: boolean, stamp = entry.stamp): BatchNode {
    const next = this.#next;
    if (next !== undefined && next.record === record) return next;
    return (this.#next = new BatchNode(this, entry, record, isEvent, stamp));
  }

  get records(): readonly Uint8Array[] {
    return (this.#records ??=
      // One record is what a turn has in it as long as nothing is in a hurry.
      this.count === 1 ? [this.record!] : this.nodes().map((node) => node.record!));
  }

  /** The nodes of this chain that hold a record, oldest first. */
  nodes(): BatchNode[] {
    const nodes = new Array<BatchNode>(this.count);
    if (this.count > 0) nodes[this.count - 1] = this;
    for (let i = this.count - 2; i >= 0; i--) nodes[i] = nodes[i + 1]!.previous!;
    return nodes;
  }

  memo<T>(encoder: BatchEncoder<T>): T {
    if (this.#encoder === encoder) return this.#encoded as T;
    if (this.#encoder === undefined) {
      const encoded = encoder.encode(this);
      this.#encoder = encoder;
      this.#encoded = encoded;
      return encoded;
    }
    // A second kind of encoder at work on the same batch: rare enough for a map.
    this.#otherEncoded ??= new Map();
    if (!this.#otherEncoded.has(encoder)) this.#otherEncoded.set(encoder, encoder.encode(this));
    return this.#otherEncoded.get(encoder) as T;
  }
}
