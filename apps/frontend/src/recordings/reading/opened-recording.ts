import { fromJson, type PersonalLabel } from '@ubii/proto';
import type { RecordingSummary } from '@ubii/recording';
import type { OpenedRecording } from './recording-messages.ts';
import { TimeBase } from './recording-time-base.ts';

/** Files of nodes have clients that publish nothing, and those of other programs have publishers only. */
export function clientNamesOf({
  topics,
  clients,
}: Pick<RecordingSummary, 'topics' | 'clients'>): Map<string, string> {
  const names = [
    ...topics.map(({ clientId, clientName }) => [clientId, clientName] as const),
    ...clients.map(({ id, name }) => [id, name] as const),
  ];
  return new Map(names.filter(([id, name]) => id !== '' && name !== ''));
}

/** What the page shows of a file that was opened. */
export function openedRecording(summary: RecordingSummary): OpenedRecording {
  const base = new TimeBase(summary.startNs);
  return {
    name: summary.name,
    notes: summary.notes,
    masterName: summary.masterName,
    startMs: base.startMs,
    durationMs: base.toMs(summary.endNs),
    records: summary.records,
    topics: summary.topics.map((one) => ({
      topic: one.topic,
      clientId: one.clientId,
      records: one.records,
      format: one.isRaw ? one.schemaName : one.format,
    })),
    clientNames: clientNamesOf(summary),
    markers: summary.markers.map(({ id, timeMs, text, author }) => ({
      id,
      text,
      author,
      timeMs: base.placed(timeMs),
    })),
    gaps: summary.gaps.map(({ topic, fromMs, untilMs, records, reason }) => ({
      topic,
      records,
      reason,
      fromMs: base.placed(fromMs),
      untilMs: base.placed(untilMs),
    })),
    isDamaged: summary.isDamaged,
    labels: labelsOf(summary),
  };
}

/** Labels of personal data in a header; none when they cannot be read. */
export function labelsOf({
  personalData = '{}',
}: Pick<RecordingSummary, 'personalData'>): readonly PersonalLabel[] {
  try {
    return fromJson('ubii.extension.PersonalData', JSON.parse(personalData)).labels;
  } catch {
    return [];
  }
}
