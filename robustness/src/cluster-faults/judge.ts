import type { PublisherRow, ReceptionRow } from './clients/reception.ts';

/** Facts of one phase of a run. */
export interface PhaseFacts {
  readonly publishers: readonly PublisherRow[];
  readonly receptions: readonly ReceptionRow[];
  /** Index of the master with this URL. */
  readonly indexOf: (url: string) => number;
  readonly mayLose: (publisherAt: number, subscriberAt: number) => boolean;
  /** Masters that noticed a loss between masters, by index. [CU-40] */
  readonly noticed: ReadonlySet<number>;
}

/** What became of the records of one phase of a run. */
export interface Judgement {
  readonly received: number;
  /** Records that came twice to a client that kept its connection. */
  readonly again: number;
  readonly disorder: number;
  /** Records that are missing, by the reason why they may be. */
  readonly missing: Readonly<Record<string, number>>;
  /** Against the specification, in words. */
  readonly violations: readonly string[];
}

/**
 * Finds records that came twice, in another order, or are missing without a reason that the specification of clusters
 * knows.
 */
export function judge(facts: PhaseFacts): Judgement {
  const publishers = new Map(facts.publishers.map((row) => [row.topic, row]));
  const missing: Record<string, number> = {};
  const violations: string[] = [];
  let [received, again, disorder] = [0, 0, 0];
  for (const row of facts.receptions) {
    received += row.received;
    disorder += row.disorder;
    if (!row.moved) again += row.again;
    const place = `${row.topic}, received at ${row.home}`;
    if (row.disorder > 0) violations.push(`${row.disorder} records out of order: ${place}`);
    // The record that stands comes again when a client subscribes again. [CL-40]
    if (row.again > 0 && !row.moved) {
      violations.push(`${row.again} records twice: ${place}`);
    }
    if (row.missing === 0) continue;
    const reason = reasonFor(row, publishers.get(row.topic), facts);
    if (reason === undefined) violations.push(`${row.missing} records missing: ${place}`);
    else missing[reason] = (missing[reason] ?? 0) + row.missing;
  }
  return { received, again, disorder, missing, violations };
}

function reasonFor(
  subscriber: ReceptionRow,
  publisher: PublisherRow | undefined,
  { indexOf, mayLose, noticed }: PhaseFacts,
): string | undefined {
  if (subscriber.moved) return 'the subscriber had no connection for a while [CU-83]';
  if (publisher === undefined) return undefined;
  if (publisher.moved) return 'the publisher had no connection for a while [CU-83]';
  const [from, to] = [indexOf(publisher.home), indexOf(subscriber.home)];
  if (from === to) return undefined;
  if (mayLose(from, to)) return 'its masters were apart [CU-7]';
  return noticed.has(to) ? 'its master noticed that something was missing [CU-7]' : undefined;
}
