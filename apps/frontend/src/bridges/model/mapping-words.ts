import type { LaneReport, MappingReport } from './bridge-report.ts';
import type { WrittenMapping } from './mapping-changes.ts';

/** How a mapping carries values, in short words: `double · JSON value.celsius · QoS 1 · retained`. */
export function carriageOf(mapping: WrittenMapping, protocol: string): string {
  const { format, payload = 'json', field, qos, retained, type, timeTag, maxRateHz } = mapping;
  const words: unknown[] = [format ?? 'any format'];
  if (protocol === 'mqtt') {
    words.push(typeof field === 'string' && field !== '' ? `${String(payload)} ${field}` : payload);
  }
  words.push(type, qos === undefined || qos === 0 ? undefined : `QoS ${String(qos)}`);
  words.push(retained === true ? 'retained' : undefined);
  words.push(timeTag === true ? 'time tag' : undefined);
  words.push(typeof maxRateHz === 'number' && maxRateHz > 0 ? `at most ${maxRateHz}/s` : undefined);
  return words.filter((word) => typeof word === 'string' && word !== '').join(' · ');
}

const DIRECTIONS: Readonly<Record<string, string>> = {
  in: 'into Ubi-Interact',
  out: 'out of Ubi-Interact',
  both: 'in both directions',
};

export function directionWords(direction: unknown): string {
  return DIRECTIONS[String(direction)] ?? '';
}

/** The newest of something that both directions have. */
function newest<T extends { readonly atMs: number }>(
  report: MappingReport | undefined,
  of: (lane: LaneReport) => T | undefined,
): T | undefined {
  const all = [report?.in, report?.out].flatMap((lane) => (lane && of(lane)) ?? []);
  return all.reduce<T | undefined>(
    (last, one) => (last && last.atMs >= one.atMs ? last : one),
    undefined,
  );
}

/** The last value that passed, whichever the direction. */
export const lastValueOf = (report: MappingReport | undefined) =>
  newest(report, ({ lastValue }) => lastValue);

/** The last message that was refused or dropped, with the reason. */
export const lastErrorOf = (report: MappingReport | undefined) =>
  newest(report, ({ lastError }) => lastError);

/** How many messages and records passed, in both directions. */
export function passedOf(report: MappingReport | undefined): number {
  return (report?.in?.passed ?? 0) + (report?.out?.passed ?? 0);
}

/** How many messages were refused and dropped, and addresses evicted, in words; empty for none. */
export function lossesOf(report: MappingReport | undefined): string {
  const sum = (member: 'refused' | 'dropped' | 'evicted'): number =>
    (report?.in?.[member] ?? 0) + (report?.out?.[member] ?? 0);
  const parts = [
    [sum('refused'), 'refused'],
    [sum('dropped'), 'dropped'],
    [sum('evicted'), 'evicted'],
  ] as const;
  return parts
    .filter(([count]) => count > 0)
    .map(([count, word]) => `${count} ${word}`)
    .join(', ');
}
