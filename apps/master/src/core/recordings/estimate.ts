import type { RecordingEstimate, RecordingTopicRate } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { dataFormatOf, type TopicEntry } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import { isImageField, type CompiledSelection } from './selection.ts';

/** Duration of the measurement, milliseconds. */
const MEASURED_MS = 1_000;

/** Measures what a selection takes. [RC-15] */
export async function estimate(
  { topics, clock }: { readonly topics: TopicTable; readonly clock: Clock },
  selection: CompiledSelection,
): Promise<Omit<RecordingEstimate, 'freeBytes'>> {
  const before = new Map<TopicEntry, { readonly records: number; readonly bytes: number }>();
  for (const entry of topics.values()) before.set(entry, { ...countsOf(entry) });
  const startMs = clock.monotonicMs();
  await new Promise<void>((resolve) => clock.after(MEASURED_MS, resolve));
  const perSecond = 1_000 / (clock.monotonicMs() - startMs);
  const rates: RecordingTopicRate[] = [];
  for (const entry of topics.values()) {
    if (!isSelected(entry, selection)) continue;
    const { records, bytes } = countsOf(entry);
    const old = before.get(entry) ?? { records: 0, bytes: 0 };
    rates.push({
      topic: entry.topic,
      dataFormat: dataFormatOf(entry),
      recordsPerSecond: (records - old.records) * perSecond,
      bytesPerSecond: (bytes - old.bytes) * perSecond,
    });
  }
  rates.sort((a, b) => b.bytesPerSecond - a.bytesPerSecond);
  return {
    topics: rates,
    recordsPerSecond: sum(rates, 'recordsPerSecond'),
    bytesPerSecond: sum(rates, 'bytesPerSecond'),
  };
}

function isSelected(entry: TopicEntry, selection: CompiledSelection): boolean {
  if (entry.isMasters || entry.record === undefined) return false;
  if (selection.withoutImages && isImageField(entry.valueField)) return false;
  return selection.selects(entry.topic, entry.publisherId);
}

function countsOf({ records, bytes }: TopicEntry): { records: number; bytes: number } {
  return { records, bytes };
}

function sum(
  rates: readonly RecordingTopicRate[],
  member: 'recordsPerSecond' | 'bytesPerSecond',
): number {
  return rates.reduce((total, rate) => total + rate[member], 0);
}
