import type { SandboxRecord } from '../../ports/sandbox.ts';
import type { EncodedRecord } from '../../ports/topic-port.ts';
import type { IdentityRule } from './mux-identity.ts';

interface Element {
  record: EncodedRecord;
  receivedAtMs: number | undefined;
  readonly topicIdentity: string | undefined;
  /** As the module gets it; undefined when the record is newer. */
  handed: SandboxRecord | undefined;
}

/** The newest record of each topic a muxer selected, in order of first appearance. [PM-40] [PM-44] */
export class MuxList {
  readonly #rule: IdentityRule;
  readonly #maxElements: number;
  readonly #elements = new Map<string, Element>();
  #handed: readonly SandboxRecord[] | undefined = [];

  constructor(rule: IdentityRule, maxElements: number) {
    this.#rule = rule;
    this.#maxElements = maxElements;
  }

  get size(): number {
    return this.#elements.size;
  }

  /**
   * Takes a record. Returns false when the list is full.
   * @param receivedAtMs milliseconds since the Unix epoch, master's clock; undefined: not known
   */
  set(record: EncodedRecord, receivedAtMs?: number): boolean {
    const element = this.#elements.get(record.topic);
    if (element !== undefined) {
      element.record = record;
      element.receivedAtMs = receivedAtMs;
      element.handed = undefined;
    } else {
      if (this.#elements.size >= this.#maxElements) return false;
      const topicIdentity = this.#rule.ofTopic(record.topic);
      this.#elements.set(record.topic, { record, receivedAtMs, topicIdentity, handed: undefined });
    }
    this.#handed = undefined;
    return true;
  }

  /** The value of a topic is gone. */
  delete(topic: string): void {
    if (this.#elements.delete(topic)) this.#handed = undefined;
  }

  clear(): void {
    this.#elements.clear();
    this.#handed = undefined;
  }

  get(topic: string): EncodedRecord | undefined {
    return this.#elements.get(topic)?.record;
  }

  /** The records, as they came. */
  *records(): Iterable<EncodedRecord> {
    for (const { record } of this.#elements.values()) yield record;
  }

  /** As the module gets them: the same objects until something changes. */
  read(): readonly SandboxRecord[] {
    this.#handed ??= this.#hand();
    return this.#handed;
  }

  #hand(): SandboxRecord[] {
    const handed: SandboxRecord[] = [];
    for (const element of this.#elements.values()) {
      const { record, receivedAtMs, topicIdentity } = element;
      element.handed ??= {
        bytes: record.bytes,
        identity: this.#rule.ofRecord(record) ?? topicIdentity,
        receivedAtMs,
      };
      handed.push(element.handed);
    }
    return handed;
  }
}
