import type { DataFormatFamily } from '@ubii/proto';
import type { PlotSeries } from './plot-settings.ts';

/** Style of a line: the colour of its family, then tone and dashes, so that lines never differ by colour alone. */
export interface SeriesLook {
  readonly family: DataFormatFamily;
  /** `lit` is mixed with the text colour, `dim` with the background. */
  readonly tone: 'plain' | 'lit' | 'dim';
  /** Dash pattern, pixels on and off; empty for a solid line. */
  readonly dash: readonly number[];
}

const STROKES: readonly Omit<SeriesLook, 'family'>[] = [
  { tone: 'plain', dash: [] },
  { tone: 'lit', dash: [6, 4] },
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

/** Assigns a style to each line; unique for the first twelve of a family. */
export function looksOf(families: readonly DataFormatFamily[]): readonly SeriesLook[] {
  const counts = new Map<DataFormatFamily, number>();
  return families.map((family) => {
    const count = counts.get(family) ?? 0;
    counts.set(family, count + 1);
    return { family, ...STROKES[count % STROKES.length]! };
  });
}

/** CSS colour of a line. */
export function colorOf({ family, tone }: SeriesLook): string {
  const color = `var(--family-${family})`;
  // Nearly the ink: far from the plain colour in lightness, in both themes.
  if (tone === 'lit') return `color-mix(in oklab, ${color}, var(--ink-1) 80%)`;
  return tone === 'dim' ? `color-mix(in oklab, ${color} 62%, transparent)` : color;
}

/**
 * Shortest unique names of the lines of a plot: `x`, or `position.x`. With several topics, each includes the topic:
 * `arm x`. A derivative has a prime.
 */
export function seriesNames(series: readonly PlotSeries[]): readonly string[] {
  const topics = [...new Set(series.map(({ topic }) => topic))];
  const topicNames = tellApart(topics.map((topic) => topic.split('/').filter(Boolean)));
  const names = series.map(() => '');
  topics.forEach((topic, which) => {
    const own = series.flatMap((one, i) => (one.topic === topic ? [i] : []));
    const fields = [...new Set(own.map((i) => series[i]!.path))];
    const fieldNames = tellApart(fields.map((path) => path.split('.').filter(Boolean)));
    for (const i of own) {
      const field = fieldNames[fields.indexOf(series[i]!.path)]!.join('.');
      const of = topics.length > 1 ? topicNames[which]!.join('/') : '';
      const name = [of, field].filter(Boolean).join(' ') || 'value';
      names[i] = series[i]!.isDerivative ? `${name}′` : name;
    }
  });
  return names;
}

/** Label at the end of a line, where space is short: `x`. */
export function shortSeriesName({ topic, path, isDerivative }: PlotSeries): string {
  const name = path.split('.').at(-1) || topic.split('/').at(-1) || 'value';
  return isDerivative ? `${name}′` : name;
}

/** Shortest unique ending of each path. */
function tellApart(paths: readonly (readonly string[])[]): readonly (readonly string[])[] {
  const longest = Math.max(1, ...paths.map(({ length }) => length));
  const tails = paths.map((path) => path.slice(-1));
  for (let parts = 2; parts <= longest; parts++) {
    const keys = tails.map((tail) => tail.join('/'));
    const doubles = keys.flatMap((key, i) =>
      keys.indexOf(key) !== keys.lastIndexOf(key) ? [i] : [],
    );
    if (doubles.length === 0) break;
    for (const i of doubles) tails[i] = paths[i]!.slice(-parts);
  }
  return tails;
}
