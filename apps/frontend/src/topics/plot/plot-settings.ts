import type { JsonObject, JsonValue } from '@ubii/proto';
import * as v from 'valibot';
import { flag, maybe, textUpTo, validElements } from '../../json/schemas.ts';
import { MAX_PATH } from '../values/number-fields.ts';

/** Settings of a line of a plot. */
export interface PlotSeries {
  readonly topic: string;
  /** Path of the number in the value; empty for a value that is a number itself. */
  readonly path: string;
  /** Shows its derivative, per second. */
  readonly isDerivative: boolean;
  readonly isHidden: boolean;
  /** Number of its value axis, 1 to `MAX_AXES`. */
  readonly axis: number;
}

/** Settings of a plot. */
export interface PlotSettings {
  /** `undefined` for the default: the numbers of the topic itself. */
  readonly series: readonly PlotSeries[] | undefined;
  readonly spanMs: number | undefined;
  readonly hasNumbers: boolean;
}

export const MAX_SERIES = 20;
export const MAX_AXES = 4;
export const MAX_TOPIC = 1024;
const MAX_SPAN_MS = 600_000;

export const aSeries = (topic: string, path: string): PlotSeries => ({
  topic,
  path,
  isDerivative: false,
  isHidden: false,
  axis: 1,
});

/** Key of a line of a plot. */
export const seriesKey = ({ topic, path, isDerivative }: PlotSeries): string =>
  `${topic}\n${path}${isDerivative ? '\n′' : ''}`;

const SERIES = v.pipe(
  v.object({
    topic: v.pipe(textUpTo(MAX_TOPIC), v.minLength(1)),
    path: v.optional(textUpTo(MAX_PATH), ''),
    d: flag,
    hidden: flag,
    axis: v.fallback(v.pipe(v.number(), v.integer(), v.minValue(1)), 1),
  }),
  v.transform(({ topic, path, d, hidden, axis }): PlotSeries => ({
    topic,
    path,
    isDerivative: d,
    isHidden: hidden,
    axis: Math.min(axis, MAX_AXES),
  })),
);

const SETTINGS = v.pipe(
  v.object({
    series: maybe(validElements(SERIES, MAX_SERIES)),
    span: maybe(v.pipe(v.number(), v.gtValue(0), v.maxValue(MAX_SPAN_MS))),
    numbers: flag,
  }),
  v.transform(({ series, span, numbers }): PlotSettings => ({
    series,
    spanMs: span,
    hasNumbers: numbers,
  })),
);

/** Reads unvalidated settings; omits invalid members. */
export const readPlotSettings = (settings: Readonly<JsonObject>): PlotSettings =>
  v.parse(SETTINGS, settings);

/** Short form for layouts and links. */
export function writePlotSettings({ series, spanMs, hasNumbers }: PlotSettings): JsonObject {
  return {
    ...(series ? { series: series.map(writeSeries) } : {}),
    ...(spanMs === undefined ? {} : { span: spanMs }),
    ...(hasNumbers ? { numbers: true } : {}),
  };
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

/** Adds a line, without duplicates and up to `MAX_SERIES`. */
export function withSeries(
  series: readonly PlotSeries[],
  added: readonly PlotSeries[],
): readonly PlotSeries[] {
  const keys = new Set(series.map(seriesKey));
  return [...series, ...added.filter((one) => !keys.has(seriesKey(one)))].slice(0, MAX_SERIES);
}
