import type { DataFormatFamily } from '@ubii/proto';
import type { PlotSeries } from './plot-settings.ts';

/** How a line is told apart: the colour of its family, then tone and dashes, never colour alone. */
export interface SeriesLook {
  readonly family: DataFormatFamily;
  /** `lit` is mixed with ink, `dim` lets the ground through. */
  readonly tone: 'plain' | 'lit' | 'dim';
  /** Pixels on and off; empty for a solid line. */
  readonly dash: readonly number[];
}

const STROKES: readonly Omit<SeriesLook, 'family'>[] = [
  { tone: 'plain', dash: [] },
  { tone: 'lit', dash: [4, 3] },
  { tone: 'dim', dash: [] },
  { tone: 'plain', dash: [2, 3] },
  { tone: 'lit', dash: [] },
  { tone: 'dim', dash: [4, 3] },
  { tone: 'plain', dash: [10, 3, 2, 3] },
  { tone: 'lit', dash: [2, 3] },
  { tone: 'dim', dash: [10, 3, 2, 3] },
  { tone: 'plain', dash: [4, 3] },
  { tone: 'lit', dash: [10, 3, 2, 3] },
  { tone: 'dim', dash: [2, 3] },
];

/** One look for each line: within a family no two of the first twelve are the same. */
export function looksOf(families: readonly DataFormatFamily[]): readonly SeriesLook[] {
  const counts = new Map<DataFormatFamily, number>();
  return families.map((family) => {
    const count = counts.get(family) ?? 0;
    counts.set(family, count + 1);
    return { family, ...STROKES[count % STROKES.length]! };
  });
}

/** The colour of a line, as CSS says it. */
export function colorOf({ family, tone }: SeriesLook): string {
  const color = `var(--family-${family})`;
  if (tone === 'lit') return `color-mix(in oklab, ${color}, var(--ink-1) 45%)`;
  return tone === 'dim' ? `color-mix(in oklab, ${color} 62%, transparent)` : color;
}

/**
 * The shortest names that tell the lines of a plot apart: `x`, else `position.x`, else `arm position.x`.
 * A derivative bears a prime.
 */
export function seriesNames(series: readonly PlotSeries[]): readonly string[] {
  const names = series.map((one) => nameOf(one, 1));
  for (let parts = 2; parts <= 40; parts++) {
    const counts = new Map<string, number>();
    for (const name of names) counts.set(name, (counts.get(name) ?? 0) + 1);
    const doubles = names.flatMap((name, i) => (counts.get(name)! > 1 ? [i] : []));
    if (doubles.length === 0) break;
    for (const i of doubles) names[i] = nameOf(series[i]!, parts);
  }
  return names;
}

function nameOf({ topic, path, isDerivative }: PlotSeries, count: number): string {
  const fields = path === '' ? [] : path.split('.');
  const levels = topic.split('/').filter(Boolean);
  const field = fields.slice(-count).join('.');
  const left = count - Math.max(1, fields.length);
  const level = left > 0 ? levels.slice(-left).join('/') : '';
  const name = [level, field || (level === '' ? 'value' : '')].filter(Boolean).join(' ');
  return isDerivative ? `${name}′` : name;
}
