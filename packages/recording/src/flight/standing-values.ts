import type { RecordedRecord } from '../records/recorded-record.ts';

/** Larger values are not kept once they left the window. */
const MAX_RECORD_BYTES = 16 * 1024;

/** The last value of each topic and publisher that left the window: what stands when the window begins. */
export class StandingValues {
  readonly #values = new Map<string, Map<string, RecordedRecord>>();
  #bytes = 0;

  get bytes(): number {
    return this.#bytes;
  }

  get topics(): Iterable<string> {
    return this.#values.keys();
  }

  hasTopic(topic: string): boolean {
    return this.#values.has(topic);
  }

  /** Keeps a copy in place of an earlier value. */
  set(record: RecordedRecord): void {
    const { topic, clientId } = record;
    this.#remove(topic, clientId);
    if (record.record.length > MAX_RECORD_BYTES) return;
    let byClient = this.#values.get(topic);
    if (byClient === undefined)
      this.#values.set(topic, (byClient = new Map<string, RecordedRecord>()));
    byClient.set(clientId, { ...record, record: record.record.slice() });
    this.#bytes += bytesOf(record);
  }

  forget(topic: string): void {
    for (const record of this.#values.get(topic)?.values() ?? []) this.#bytes -= bytesOf(record);
    this.#values.delete(topic);
  }

  /** Forgets the value that was kept first. */
  forgetOldest(): void {
    for (const [topic, byClient] of this.#values) {
      for (const clientId of byClient.keys()) return this.#remove(topic, clientId);
    }
  }

  *[Symbol.iterator](): Generator<RecordedRecord> {
    for (const byClient of this.#values.values()) yield* byClient.values();
  }

  #remove(topic: string, clientId: string): void {
    const byClient = this.#values.get(topic);
    const known = byClient?.get(clientId);
    if (byClient === undefined || known === undefined) return;
    this.#bytes -= bytesOf(known);
    byClient.delete(clientId);
    if (byClient.size === 0) this.#values.delete(topic);
  }
}

/** With what the two maps and the object take, about. */
function bytesOf({ topic, record }: RecordedRecord): number {
  return 256 + topic.length * 2 + record.length;
}
