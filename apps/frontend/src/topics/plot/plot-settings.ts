import type { JsonObject, JsonValue } from '@ubii/proto';
import { MAX_PATH } from '../values/number-fields.ts';

/** One line of a plot. */
export interface PlotSeries {
  readonly topic: string;
  /** Where the number stands in the value; empty for a value that is a number itself. */
  readonly path: string;
  /** Shows how fast it changes, per second. */
  readonly isDerivative: boolean;
  readonly isHidden: boolean;
  /** 1 to `MAX_AXES`. */
  readonly axis: number;
}

/** What a person set in a plot. */
export interface PlotSettings {
  /** `undefined` for the default: the numbers of the topic itself. */
  readonly series: readonly PlotSeries[] | undefined;
  readonly spanMs: number | undefined;
  readonly hasNumbers: boolean;
}

export const MAX_SERIES = 20;
export const MAX_AXES = 4;
export const MAX_TOPIC = 1024;

export const aSeries = (topic: string, path: string): PlotSeries => ({
  topic,
  path,
  isDerivative: false,
  isHidden: false,
  axis: 1,
});

/** What tells the lines of a plot apart. */
export const seriesKey = ({ topic, path, isDerivative }: PlotSeries): string =>
  `${topic}\n${path}${isDerivative ? '\n′' : ''}`;

/** Reads untrusted settings; invalid members are left out. */
export function readPlotSettings(settings: Readonly<JsonObject>): PlotSettings {
  const { series, span, numbers } = settings;
  const isSpan = typeof span === 'number' && span > 0 && span <= 600_000;
  return {
    series: Array.isArray(series) ? series.slice(0, MAX_SERIES).flatMap(readSeries) : undefined,
    spanMs: isSpan ? span : undefined,
    hasNumbers: numbers === true,
  };
}

/** The short form that goes into layouts and links. */
export function writePlotSettings({ series, spanMs, hasNumbers }: PlotSettings): JsonObject {
  return {
    ...(series ? { series: series.map(writeSeries) } : {}),
    ...(spanMs === undefined ? {} : { span: spanMs }),
    ...(hasNumbers ? { numbers: true } : {}),
  };
}

function readSeries(json: JsonValue): PlotSeries[] {
  if (typeof json !== 'object' || json === null || Array.isArray(json)) return [];
  const { topic, path = '', d, hidden, axis = 1 } = json;
  if (typeof topic !== 'string' || topic === '' || topic.length > MAX_TOPIC) return [];
  if (typeof path !== 'string' || path.length > MAX_PATH) return [];
  const isAxis = typeof axis === 'number' && Number.isInteger(axis) && axis >= 1;
  return [
    {
      topic,
      path,
      isDerivative: d === true,
      isHidden: hidden === true,
      axis: isAxis ? Math.min(axis, MAX_AXES) : 1,
    },
  ];
}

function writeSeries({ topic, path, isDerivative, isHidden, axis }: PlotSeries): JsonValue {
  return {
    topic,
    ...(path === '' ? {} : { path }),
    ...(isDerivative ? { d: true } : {}),
    ...(isHidden ? { hidden: true } : {}),
    ...(axis === 1 ? {} : { axis }),
  };
}

/** The same series and one more; none twice, and no more than `MAX_SERIES`. */
export function withSeries(
  series: readonly PlotSeries[],
  added: readonly PlotSeries[],
): readonly PlotSeries[] {
  const keys = new Set(series.map(seriesKey));
  return [...series, ...added.filter((one) => !keys.has(seriesKey(one)))].slice(0, MAX_SERIES);
}
