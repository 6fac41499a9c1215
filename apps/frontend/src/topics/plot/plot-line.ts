import type { DataFormat } from '@ubii/proto';
import type { LinePoints } from '../history/series-ring.ts';
import type { TopicHistory } from '../history/topic-history.ts';
import { derivativeOf } from './line-derivative.ts';
import { seriesKey, type PlotSeries } from './plot-settings.ts';
import { TracedLine } from './trace-line.ts';

/** A line of a plot with its data. */
export class PlotLine {
  readonly series: PlotSeries;
  readonly key: string;
  readonly history: TopicHistory;
  #points: object | undefined;
  #traced: TracedLine | undefined;

  constructor(series: PlotSeries, history: TopicHistory) {
    this.series = series;
    this.key = seriesKey(series);
    this.history = history;
  }

  /** `undefined` before the first record. */
  get traced(): TracedLine | undefined {
    // After a change of the data format, the values are different series.
    if (this.#points !== this.history.points || this.#traced === undefined) {
      const line = this.history.lineOf(this.series.path);
      this.#points = this.history.points;
      this.#traced = line && new TracedLine(this.series.isDerivative ? derivativeOf(line) : line);
    }
    return this.#traced;
  }

  get points(): LinePoints | undefined {
    return this.traced?.line;
  }

  get format(): DataFormat | undefined {
    return this.history.latest?.format;
  }

  /** Bool values hold until the next one. */
  get isStepped(): boolean {
    return this.format === 'bool' && !this.series.isDerivative;
  }

  /** Key of the value axis; lines with the same key share it. */
  get scale(): string {
    return scaleOf(this.series);
  }
}

export const scaleOf = ({ axis, isDerivative }: PlotSeries): string =>
  `y${axis}${isDerivative ? '′' : ''}`;
