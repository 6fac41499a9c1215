import { durationFigure, durationFigures } from '../measure/duration-figures.ts';
import { Durations } from '../measure/durations.ts';
import type { Findings, Histogram } from '../measure/findings.ts';
import { histogramOf } from '../measure/histogram.ts';
import { overTime } from '../measure/over-time.ts';
import { wait, waitUntil, type TestRun } from '../measure/test-run.ts';

export interface ScreenParameters {
  /** Mean rate of values, Hz. */
  readonly rateHz: number;
  readonly seconds: number;
}

/** A topic with a number, and the means to display it. */
export interface ScreenWorld {
  publish(value: number): void;
  onValue(fn: (value: number) => void): void;
  /** Displays a value; called in an animation frame. */
  draw(value: number): void;
  /** Calls `fn` in the next animation frame, before the browser paints. */
  nextFrame(fn: () => void): void;
  /** 0 to 1. */
  random(): number;
}

const WARM_UP_MS = 300;
const GRACE_MS = 1000;
const REPORT_MS = 500;

interface Seen {
  readonly sentMs: number;
  receivedMs: number | undefined;
}

/** Measures the time from publishing a value to the frame that displays it. */
export async function measureScreen(
  { rateHz, seconds }: ScreenParameters,
  world: ScreenWorld,
  run: TestRun,
): Promise<Findings> {
  const { clock, signal } = run;
  const underway = new Map<number, Seen>();
  let received = new Durations();
  let total = new Durations();
  let waited = new Durations();
  let frames = new Durations();
  let newest: number | undefined;
  let sent = 0;
  let countsFrom = Infinity;
  let isOver = false;
  let frameMs: number | undefined;

  world.onValue((value) => {
    const seen = underway.get(value);
    if (seen === undefined) return;
    seen.receivedMs ??= clock.monotonicMs();
    newest = value;
  });

  /** Values received so far are visible after this frame. */
  function frame(): void {
    if (isOver) return;
    const nowMs = clock.monotonicMs();
    if (frameMs !== undefined) frames.add(nowMs - frameMs, nowMs);
    frameMs = nowMs;
    if (newest !== undefined) {
      world.draw(newest);
      const drawnMs = clock.monotonicMs();
      for (const [value, { sentMs, receivedMs }] of underway) {
        if (receivedMs === undefined) continue;
        underway.delete(value);
        if (value < countsFrom) continue;
        received.add(receivedMs - sentMs, drawnMs);
        waited.add(drawnMs - receivedMs, drawnMs);
        total.add(drawnMs - sentMs, drawnMs);
      }
      newest = undefined;
    }
    world.nextFrame(frame);
  }
  world.nextFrame(frame);

  async function publishFor(forMs: number): Promise<void> {
    const untilMs = clock.monotonicMs() + forMs;
    while (!signal.aborted && clock.monotonicMs() < untilMs) {
      underway.set(sent, { sentMs: clock.monotonicMs(), receivedMs: undefined });
      world.publish(sent++);
      // At random intervals: a steady rate would always meet the same phase of the frame.
      await wait((0.5 + world.random()) * (1000 / rateHz), run);
    }
  }

  await publishFor(WARM_UP_MS);
  countsFrom = sent;
  [received, total, waited, frames] = [0, 0, 0, 0].map(() => new Durations()) as [
    Durations,
    Durations,
    Durations,
    Durations,
  ];
  const startedMs = clock.monotonicMs();
  const findings = (lost: number | undefined): Findings =>
    screenFindings({ received, waited, total, frames, startedMs, sent: sent - countsFrom, lost });
  const cancel = clock.every(REPORT_MS, () =>
    run.report({
      share: Math.min(1, (clock.monotonicMs() - startedMs) / (seconds * 1000)),
      words: 'Publishing and drawing',
      findings: findings(undefined),
    }),
  );
  await publishFor(seconds * 1000);
  const isFull = !signal.aborted;
  await waitUntil(() => underway.size === 0, GRACE_MS, run);
  cancel();
  isOver = true;
  return findings(isFull ? sent - countsFrom - total.count : undefined);
}

function screenFindings(counts: {
  received: Durations;
  waited: Durations;
  total: Durations;
  frames: Durations;
  startedMs: number;
  sent: number;
  lost: number | undefined;
}): Findings {
  const { received, waited, total, frames, startedMs, sent, lost } = counts;
  const isHistogram = (one: Histogram | undefined): one is Histogram => one !== undefined;
  const curve = overTime('total', 'Published to drawn, over time', total, startedMs);
  const frame = frames.summary();
  return {
    figures: [
      ...durationFigures('total', '', total.summary()),
      ...durationFigures('received', 'To the page', received.summary()).slice(0, 2),
      ...durationFigures('waited', 'Page to frame', waited.summary()).slice(0, 2),
      ...(frame
        ? [
            durationFigure('frame.p50', 'Frame p50', frame.p50Ms),
            durationFigure('frame.p95', 'Frame p95', frame.p95Ms),
          ]
        : []),
      { key: 'sent', label: 'Published', value: sent, unit: '' },
      { key: 'drawn', label: 'Drawn', value: total.count, unit: '' },
      ...(lost === undefined
        ? []
        : [{ key: 'lost', label: 'Lost', value: lost, unit: '', better: 'less' as const }]),
    ],
    histograms: [
      histogramOf('total', 'Published to drawn', total.values),
      histogramOf('received', 'Published to received', received.values),
    ].filter(isHistogram),
    curves: curve ? [curve] : [],
    notes: [],
  };
}
