import type { ClusterRecords } from '@ubii/proto';
import { readRecordHead } from '@ubii/proto/wire';
import { TextCache } from '@ubii/proto/wire';
import type { Clock, EndOfTurn } from '@ubii/timing';
import { publishForeign, type ForeignContext } from '../topics/foreign-records.ts';
import { Publication } from '../topics/publication.ts';

/** Dependencies of received records. */
export interface ReceivedRecordsContext extends ForeignContext {
  readonly clock: Clock;
  readonly endOfTurn: EndOfTurn;
}

const NO_BYTES = new Uint8Array(0);

/** Gives the records of other masters to the topics of this one. */
export class ReceivedRecords {
  readonly #context: ReceivedRecordsContext;
  readonly #publication = new Publication();
  readonly #texts = new TextCache();

  constructor(context: ReceivedRecordsContext) {
    this.#context = context;
  }

  /**
   * @param masterId where they were published
   * @param isValues they are values that stand, and not new
   * @param topics gets their topics
   * @throws DecodeError when one cannot be read, after those before it
   */
  publish(
    masterId: string,
    part: ClusterRecords,
    isValues: boolean,
    topics: Set<string> | undefined,
  ): void {
    const { clock } = this.#context;
    const publication = this.#publication;
    publication.nowMs = clock.nowMs();
    publication.monotonicMs = clock.monotonicMs();
    for (const [i, record] of part.records.entries()) {
      const { topic, valueField } = readRecordHead(record, this.#texts);
      publication.topic = topic;
      publication.frame = record;
      publication.end = record.byteLength;
      publication.valueField = valueField;
      publishForeign(this.#context, publication, {
        masterId,
        publisherId: part.publisherIds[part.publishers[i] ?? -1] ?? '',
        stamp: part.stamps[i] ?? 0,
        isValue: isValues,
      });
      topics?.add(topic);
    }
    publication.frame = NO_BYTES;
  }
}
