import { durationFigure, durationFigures } from '../measure/duration-figures.ts';
import { Durations } from '../measure/durations.ts';
import { joinFindings, NO_FINDINGS, type Findings } from '../measure/findings.ts';
import { histogramOf } from '../measure/histogram.ts';
import { overTime } from '../measure/over-time.ts';
import { Pace } from '../measure/pace.ts';
import { wait, waitUntil, type TestRun } from '../measure/test-run.ts';

/** Way of publishing: at once, or with the next flush of the client. */
export type PublishWay = 'immediate' | 'aggregated';

export interface RoundTripParameters {
  readonly ways: readonly PublishWay[];
  /** Records per second, for each way of publishing. */
  readonly rateHz: number;
  /** Duration per way of publishing, seconds. */
  readonly seconds: number;
}

/** Topic with publishing and subscription. */
export interface EchoTopic {
  publish(sequence: number, way: PublishWay): void;
  onEcho(fn: (sequence: number) => void): void;
}

/** Time before the measurement, for connection and compiler to warm up, milliseconds. */
const WARM_UP_MS = 300;
/** Time after which missing records count as lost, milliseconds. */
const GRACE_MS = 2000;
const TICK_MS = 4;
const REPORT_MS = 500;
/** Most records published at once after a timer delay. */
const MAX_AT_ONCE = 8;

const WAY_WORDS: Readonly<Record<PublishWay, string>> = {
  immediate: 'Immediate',
  aggregated: 'Aggregated',
};

/** Publishes numbered records at a steady rate and measures the round trip of each. */
export async function measureRoundTrip(
  { ways, rateHz, seconds }: RoundTripParameters,
  topic: EchoTopic,
  run: TestRun,
): Promise<Findings> {
  const sentMs = new Map<number, number>();
  let sequence = 0;
  let durations = new Durations();
  let returned = 0;
  let phaseFrom = 0;
  topic.onEcho((of) => {
    const atMs = run.clock.monotonicMs();
    const sent = sentMs.get(of);
    if (sent === undefined) return; // A duplicate, or a record of another client.
    sentMs.delete(of);
    if (of < phaseFrom) return;
    returned += 1;
    durations.add(atMs - sent, atMs);
  });

  const done: Findings[] = [];
  for (const [index, way] of ways.entries()) {
    if (run.signal.aborted) break;
    const words = `${WAY_WORDS[way]}, ${rateHz} records per second`;
    const publish = (): void => {
      sentMs.set(sequence, run.clock.monotonicMs());
      topic.publish(sequence++, way);
    };
    const warmUp = new Pace(rateHz, run.clock.monotonicMs(), MAX_AT_ONCE);
    await keepPace(warmUp, WARM_UP_MS, publish, run);

    phaseFrom = sequence;
    durations = new Durations();
    returned = 0;
    const startedMs = run.clock.monotonicMs();
    const pace = new Pace(rateHz, startedMs, MAX_AT_ONCE);
    const findings = (): Findings =>
      wayFindings(way, {
        durations,
        startedMs,
        sent: sequence - phaseFrom,
        returned,
        lost: undefined,
        skipped: pace.skipped,
      });
    const cancel = run.clock.every(REPORT_MS, () => {
      const share = (run.clock.monotonicMs() - startedMs) / (seconds * 1000);
      run.report({
        share: Math.min(1, (index + Math.min(1, share)) / ways.length),
        words,
        findings: joinFindings([...done, findings()]),
      });
    });
    await keepPace(pace, seconds * 1000, publish, run);
    // When aborted, do not wait for late records, and do not count them as lost.
    const isFull = !run.signal.aborted;
    await waitUntil(() => returned >= sequence - phaseFrom, GRACE_MS, run);
    cancel();
    const sent = sequence - phaseFrom;
    done.push(
      wayFindings(way, {
        durations,
        startedMs,
        sent,
        returned,
        lost: isFull ? sent - returned : undefined,
        skipped: pace.skipped,
      }),
    );
  }
  return done.length === 0 ? NO_FINDINGS : joinFindings(done);
}

async function keepPace(pace: Pace, forMs: number, publish: () => void, run: TestRun) {
  const untilMs = run.clock.monotonicMs() + forMs;
  while (!run.signal.aborted && run.clock.monotonicMs() < untilMs) {
    for (let due = pace.due(run.clock.monotonicMs()); due > 0; due--) publish();
    await wait(TICK_MS, run);
  }
}

interface WayCounts {
  readonly durations: Durations;
  readonly startedMs: number;
  readonly sent: number;
  readonly returned: number;
  readonly lost: number | undefined;
  readonly skipped: number;
}

function wayFindings(way: PublishWay, counts: WayCounts): Findings {
  const { durations, startedMs, sent, returned, lost, skipped } = counts;
  const word = WAY_WORDS[way];
  const summary = durations.summary();
  const histogram = histogramOf(way, `${word}: round trips`, durations.values);
  const curve = overTime(way, `${word}, over time`, durations, startedMs);
  const count = (key: string, label: string, value: number) =>
    ({ key: `${way}.${key}`, label: `${word} ${label}`, value, unit: '' }) as const;
  return {
    figures: [
      ...durationFigures(way, word, summary),
      ...(summary ? [durationFigure(`${way}.jitter`, `${word} jitter`, summary.jitterMs)] : []),
      count('sent', 'sent', sent),
      count('returned', 'returned', returned),
      ...(lost === undefined ? [] : [{ ...count('lost', 'lost', lost), better: 'less' as const }]),
    ],
    histograms: histogram ? [histogram] : [],
    curves: curve ? [curve] : [],
    notes:
      skipped > 0
        ? [
            `${word}: the page was too busy to publish ${skipped} of ${skipped + sent} records in time; they were skipped, so the rate was lower than set.`,
          ]
        : [],
  };
}
