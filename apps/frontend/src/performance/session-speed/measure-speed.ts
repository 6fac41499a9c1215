import type { SessionStatistics } from '@ubii/proto';
import { Durations } from '../measure/durations.ts';
import { NO_FINDINGS, type Findings } from '../measure/findings.ts';
import { wait, waitUntil, type TestRun } from '../measure/test-run.ts';
import { speedFindings } from './speed-findings.ts';
import type { SpeedParameters } from './speed-parameters.ts';

/** A running session, as observed by the test. */
export interface SpeedSession {
  onStatistics(fn: (statistics: SessionStatistics) => void): void;
  /** Called with the duration of each run of the first module, as measured by itself, milliseconds. */
  onDuration(fn: (durationMs: number) => void): void;
  /** Called with a stamp when the first module outputs it. */
  onEcho(fn: (stamp: number) => void): void;
  stamp(stamp: number): void;
  /** Ends and removes the session. */
  remove(): Promise<void>;
}

/** Starts sessions. */
export interface SpeedWorld {
  /**
   * Starts the session and waits until all modules run.
   * @throws {Error} with the reason why it does not run
   */
  start(parameters: SpeedParameters, run: TestRun): Promise<SpeedSession>;
}

const WARM_UP_MS = 1000;
const TICK_MS = 4;
const REPORT_MS = 250;
/** With trigger on input, the next stamp is sent when the previous one is back, or after this time, milliseconds. */
const ECHO_TIMEOUT_MS = 2000;
/** Interval of stamps in other modes, where they only measure the age of outputs, milliseconds. */
const STAMP_INTERVAL_MS = 50;
/** Time for the last statistics after the session ended, milliseconds. */
const LAST_REPORT_MS = 600;

/** Starts the session, measures it and always removes it. */
export async function measureSpeed(
  parameters: SpeedParameters,
  world: SpeedWorld,
  run: TestRun,
): Promise<Findings> {
  const { clock, signal } = run;
  run.report({ share: 0, words: 'Starting the session' });
  const askedMs = clock.monotonicMs();
  const session = await world.start(parameters, run);
  try {
    const startMs = clock.monotonicMs() - askedMs;
    if (signal.aborted) return NO_FINDINGS;
    return await measure(parameters, session, startMs, run);
  } finally {
    run.report({ share: 1, words: 'Removing the session' });
    await session.remove();
  }
}

async function measure(
  parameters: SpeedParameters,
  session: SpeedSession,
  startMs: number,
  run: TestRun,
): Promise<Findings> {
  const { clock, signal } = run;
  const isTriggered = parameters.mode === 'triggerOnInput';
  let durations = new Durations();
  let echoes = new Durations();
  const reports: SessionStatistics[] = [];
  let isCounting = false;
  session.onDuration((durationMs) => {
    if (isCounting) durations.add(durationMs, clock.monotonicMs());
  });
  session.onStatistics((statistics) => {
    if (isCounting) reports.push(statistics);
  });

  let stamp = 0;
  let stampedMs = -Infinity;
  let isBack = true;
  session.onEcho((of) => {
    if (of !== stamp || isBack) return; // An earlier or repeated stamp.
    isBack = true;
    const nowMs = clock.monotonicMs();
    echoes.add(nowMs - stampedMs, nowMs);
    // Immediately: a delay here would be measured as a delay of the modules.
    if (isTriggered && !signal.aborted) next();
  });
  function next(): void {
    stamp += 1;
    isBack = false;
    stampedMs = clock.monotonicMs();
    session.stamp(stamp);
  }
  async function stampFor(forMs: number): Promise<void> {
    const untilMs = clock.monotonicMs() + forMs;
    while (!signal.aborted && clock.monotonicMs() < untilMs) {
      const sinceMs = clock.monotonicMs() - stampedMs;
      const isDue = isTriggered ? isBack : isBack && sinceMs >= STAMP_INTERVAL_MS;
      if (isDue || sinceMs > ECHO_TIMEOUT_MS) next();
      await wait(TICK_MS, run);
    }
  }

  run.report({ share: 0, words: 'Warming up' });
  await stampFor(WARM_UP_MS);
  durations = new Durations();
  echoes = new Durations();
  isCounting = true;
  const startedMs = clock.monotonicMs();
  const findings = (): Findings =>
    speedFindings(parameters, { reports, durations, echoes, startMs, startedMs });
  const cancel = clock.every(REPORT_MS, () =>
    run.report({
      share: Math.min(1, (clock.monotonicMs() - startedMs) / (parameters.seconds * 1000)),
      words: 'Modules run',
      findings: findings(),
    }),
  );
  await stampFor(parameters.seconds * 1000);
  cancel();
  if (reports.length === 0) await waitUntil(() => reports.length > 0, LAST_REPORT_MS, run);
  isCounting = false;
  return findings();
}
