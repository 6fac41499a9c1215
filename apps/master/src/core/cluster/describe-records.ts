import type { ClusterRecords, Init } from '@ubii/proto';
import type { TopicEntry } from '../topics/topic-entry.ts';

/** A record with its topic, whose stamp and publisher are those of its newest record. */
export interface DescribedRecord {
  readonly entry: TopicEntry;
  readonly record: Uint8Array;
}

/** Records as they are sent to other masters: each publisher is named once. */
export function describeRecords(described: readonly DescribedRecord[]): Init<ClusterRecords> {
  const places = new Map<string, number>();
  const records: Uint8Array[] = [];
  const stamps: number[] = [];
  const publishers: number[] = [];
  for (const { entry, record } of described) {
    let place = places.get(entry.publisherId);
    if (place === undefined) {
      place = places.size;
      places.set(entry.publisherId, place);
    }
    records.push(record);
    stamps.push(entry.stamp);
    publishers.push(place);
  }
  return { records, stamps, publishers, publisherIds: [...places.keys()] };
}
