import { NO_FINDINGS, type Figure, type Findings } from '../measure/findings.ts';
import { findKnee, type Knee, type LoadStep } from './knee.ts';
import type { LoadParameters } from './load-parameters.ts';

/** CPU use from which the master is at its limit, percent of one core. */
const MASTER_BUSY_PERCENT = 85;

/** Returns the findings of the steps so far. */
export function loadFindings({ sizeBytes }: LoadParameters, steps: readonly LoadStep[]): Findings {
  if (steps.length === 0) return NO_FINDINGS;
  const knee = findKnee(steps);
  const good = steps[knee.lastGood];
  const x = {
    label: 'Records per second',
    unit: '',
    values: steps.map(({ wantedHz }) => wantedHz),
  };
  const line = (key: string, label: string, of: (step: LoadStep) => number | undefined) => ({
    key,
    label,
    values: steps.map((step) => of(step) ?? null),
  });
  const mark = good === undefined ? {} : { mark: { x: good.wantedHz, text: 'knee' } };
  return {
    figures: kneeFigures(good, sizeBytes, steps),
    histograms: [],
    curves: [
      {
        key: 'latency',
        title: 'Latency by rate',
        x,
        y: { label: 'Latency', unit: 'ms' },
        lines: [
          line('p50', 'p50', ({ p50Ms }) => p50Ms),
          line('p95', 'p95', ({ p95Ms }) => p95Ms),
          line('p99', 'p99', ({ p99Ms }) => p99Ms),
        ],
        ...(knee.firstBad === undefined ? {} : mark),
        isLogarithmic: true,
      },
      {
        key: 'busy',
        title: 'CPU load',
        x,
        y: { label: 'Load', unit: '%' },
        lines: [
          line('master', 'Master, one core', ({ masterCpuPercent }) => masterCpuPercent),
          line('lost', 'Lost records', ({ lostShare }) => lostShare * 100),
        ],
        isLogarithmic: true,
      },
    ],
    notes: [kneeNote(knee, steps)],
  };
}

function kneeFigures(
  good: LoadStep | undefined,
  sizeBytes: number,
  steps: readonly LoadStep[],
): Figure[] {
  const top = steps.reduce((a, b) => (b.deliveredHz > a.deliveredHz ? b : a));
  const peak: Figure = {
    key: 'peak',
    label: 'Maximum delivery rate',
    value: Math.round(top.deliveredHz),
    unit: '/s',
    better: 'more',
  };
  const lost: Figure = {
    key: 'lost',
    label: 'Maximum loss in a step',
    value: Math.max(...steps.map(({ lostShare }) => lostShare)) * 100,
    unit: '%',
    decimals: 2,
    better: 'less',
  };
  const lag: Figure = {
    key: 'lag.p95',
    label: 'Browser delay, p95',
    value: Math.max(...steps.map(({ lagP95Ms }) => lagP95Ms)),
    unit: 'ms',
    decimals: 1,
    better: 'less',
  };
  if (good === undefined) return [peak, lost, lag];
  const ms = (key: string, label: string, value: number): Figure => ({
    key,
    label,
    value,
    unit: 'ms',
    decimals: 2,
    better: 'less',
  });
  return [
    {
      key: 'knee',
      label: 'Knee',
      value: Math.round(good.sentHz),
      unit: 'rec/s',
      better: 'more',
    },
    {
      key: 'knee.bytes',
      label: 'Values at the knee',
      value: (good.deliveredHz * sizeBytes) / 1e6,
      unit: 'MB/s',
      decimals: 2,
      better: 'more',
    },
    ms('knee.p50', 'p50 at the knee', good.p50Ms),
    ms('knee.p95', 'p95 at the knee', good.p95Ms),
    ms('first.p50', 'p50 at the lowest rate', steps[0]!.p50Ms),
    ms('first.p95', 'p95 at the lowest rate', steps[0]!.p95Ms),
    peak,
    lost,
    lag,
  ];
}

/** Describes the knee and the limiting component in sentences. */
function kneeNote({ firstBad, lastGood, trouble, isBrowser }: Knee, steps: readonly LoadStep[]) {
  const last = steps.at(-1)!;
  if (firstBad === undefined) {
    return `No knee up to ${last.wantedHz} records per second. Raise the highest rate to find the limit.`;
  }
  const bad = steps[firstBad]!;
  const what = {
    latency: 'latency rose',
    losses: 'records were lost',
    browser: 'this browser could not publish at this rate',
  }[trouble ?? 'latency'];
  const where = `At ${bad.wantedHz} records per second ${what}${lastGood === -1 ? ', already in the first step' : ''}.`;
  if (isBrowser) {
    return `${where} This browser was the limit: its load generator was ${bad.lagP95Ms.toFixed(0)} ms late. The master may handle more. Test from several browsers, or on a faster computer.`;
  }
  if ((bad.masterCpuPercent ?? 0) >= MASTER_BUSY_PERCENT) {
    return `${where} The master was the limit: it used ${bad.masterCpuPercent!.toFixed(0)} % of a core.`;
  }
  return `${where} Neither this browser nor the CPU of the master was fully loaded: check the network and other programs on the computers.`;
}
