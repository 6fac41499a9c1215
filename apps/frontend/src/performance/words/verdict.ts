import type { Findings, TestKind } from '../measure/findings.ts';

/** Summary of the figures in one sentence. */
export interface Verdict {
  readonly tone: 'good' | 'fair' | 'poor';
  readonly text: string;
}

/** Latency below which users notice no delay, milliseconds. */
const UNNOTICED_MS = 20;
/**
 * Latency up to which a reaction feels direct, milliseconds (R. B. Miller, Response time in man-computer conversational
 * transactions, 1968).
 */
const DIRECT_MS = 100;
/** A frame at 60 Hz and a good round trip, milliseconds. */
const SCREEN_GOOD_MS = 40;

const round = (ms: number): string => (ms < 9.95 ? ms.toFixed(1) : ms.toFixed(0));

export function verdictOf(kind: TestKind, { figures }: Findings): Verdict | undefined {
  const value = (key: string): number | undefined => figures.find((one) => one.key === key)?.value;
  switch (kind) {
    case 'round-trip': {
      const p95 = value('immediate.p95') ?? value('aggregated.p95');
      return p95 === undefined ? undefined : byLatency(p95, UNNOTICED_MS, 'back');
    }
    case 'screen': {
      const p95 = value('total.p95');
      return p95 === undefined ? undefined : byLatency(p95, SCREEN_GOOD_MS, 'on the screen');
    }
    case 'load': {
      const knee = value('knee');
      const peak = value('peak');
      if (knee !== undefined) {
        return {
          tone: 'good',
          text: `About ${Math.round(knee)} records per second arrive in time.`,
        };
      }
      return peak === undefined
        ? undefined
        : { tone: 'poor', text: 'The lowest rate was already too high. Start with a lower rate.' };
    }
    case 'session-speed':
      return bySpeed(value);
  }
}

function byLatency(p95: number, goodMs: number, where: string): Verdict {
  const fact = `95 of 100 values arrive ${where} within ${round(p95)} ms`;
  if (p95 <= goodMs) return { tone: 'good', text: `${fact}: not noticeable.` };
  if (p95 <= DIRECT_MS) {
    return {
      tone: 'fair',
      text: `${fact}: good for buttons, noticeable when an object follows a hand.`,
    };
  }
  return { tone: 'poor', text: `${fact}: a noticeable delay.` };
}

function bySpeed(value: (key: string) => number | undefined): Verdict | undefined {
  const runs = value('runs');
  if (runs === undefined) return undefined;
  const late = (value('overruns') ?? 0) + (value('errors') ?? 0);
  const fact = `${runs.toFixed(0)} runs per second, p95 ${round(value('run.p95') ?? 0)} ms`;
  return late === 0
    ? { tone: 'good', text: `${fact}, none late or failed.` }
    : { tone: 'poor', text: `${fact}, but ${late.toFixed(0)} were late or failed.` };
}
