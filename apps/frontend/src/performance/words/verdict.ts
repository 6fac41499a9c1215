import { figureReadout, type Figure, type Findings, type TestKind } from '../measure/findings.ts';

/** Summary of the figures in one sentence. */
export interface Verdict {
  readonly tone: 'good' | 'fair' | 'poor';
  readonly text: string;
}

/** The worst first. */
const TONES = ['poor', 'fair', 'good'] as const;
const WAYS = [
  ['immediate', 'Immediate'],
  ['aggregated', 'Aggregated'],
] as const;
/** Latency below which users notice no delay, milliseconds. */
const UNNOTICED_MS = 20;
/**
 * Latency up to which a reaction feels direct, milliseconds (R. B. Miller, Response time in man-computer conversational
 * transactions, 1968).
 */
const DIRECT_MS = 100;
/** A frame at 60 Hz and a good round trip, milliseconds. */
const SCREEN_GOOD_MS = 40;

export function verdictOf(kind: TestKind, { figures }: Findings): Verdict | undefined {
  const figure = (key: string): Figure | undefined => figures.find((one) => one.key === key);
  const value = (key: string): number | undefined => figure(key)?.value;
  switch (kind) {
    case 'round-trip': {
      const ways = WAYS.flatMap(([key, title]) => {
        const p95 = figure(`${key}.p95`);
        return p95 ? [{ title, verdict: byLatency(p95, UNNOTICED_MS, 'back') }] : [];
      });
      return ways.length > 1 ? ofAll(ways) : ways[0]?.verdict;
    }
    case 'screen': {
      const p95 = figure('total.p95');
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
      return bySpeed(figure);
  }
}

/** The verdict of the worst, with what each one says. */
function ofAll(parts: readonly { readonly title: string; readonly verdict: Verdict }[]): Verdict {
  const tones = parts.map(({ verdict }) => verdict.tone);
  return {
    tone: TONES.find((tone) => tones.includes(tone))!,
    text: parts.map(({ title, verdict }) => `${title}: ${verdict.text}`).join(' '),
  };
}

function byLatency(p95: Figure, goodMs: number, where: string): Verdict {
  // Less is no better for people; the table has it.
  const within = p95.value < 1 ? '1 ms' : shown(p95);
  const fact = `95 of 100 values arrive ${where} within ${within}`;
  if (p95.value <= goodMs) return { tone: 'good', text: `${fact}: not noticeable.` };
  if (p95.value <= DIRECT_MS) {
    return {
      tone: 'fair',
      text: `${fact}: buttons feel direct, and what follows a hand trails behind it.`,
    };
  }
  return { tone: 'poor', text: `${fact}: a noticeable delay.` };
}

function bySpeed(figure: (key: string) => Figure | undefined): Verdict | undefined {
  const runs = figure('runs');
  if (runs === undefined) return undefined;
  const late = (figure('overruns')?.value ?? 0) + (figure('errors')?.value ?? 0);
  const p95 = figure('run.p95');
  const slowest = p95 === undefined ? '' : `, p95 ${shown(p95)}`;
  const fact = `${figureReadout(runs).digits} runs per second${slowest}`;
  return late === 0
    ? { tone: 'good', text: `${fact}, none late or failed.` }
    : { tone: 'poor', text: `${fact}, but ${late.toFixed(0)} were late or failed.` };
}

function shown(figure: Figure): string {
  const { digits, unit } = figureReadout(figure);
  return `${digits} ${unit}`;
}
