import type { ClusterRecords } from '@ubii/proto';

/** A record with its place among those of its topic, and who published it. */
export interface DescribedRecord {
  readonly record: Uint8Array;
  readonly stamp: number;
  readonly publisherId: string;
}

/** Records as they are sent to other masters: each publisher is named once. */
export function describeRecords(described: readonly DescribedRecord[]): ClusterRecords {
  const places = new Map<string, number>();
  const records: Uint8Array[] = [];
  const stamps: number[] = [];
  const publishers: number[] = [];
  for (const { record, stamp, publisherId } of described) {
    let place = places.get(publisherId);
    if (place === undefined) {
      place = places.size;
      places.set(publisherId, place);
    }
    records.push(record);
    stamps.push(stamp);
    publishers.push(place);
  }
  return { records, stamps, publishers, publisherIds: [...places.keys()] };
}
