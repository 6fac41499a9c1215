import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { seriesOf } from '../values/value-series.ts';

/** A way to look at a value. */
export type ViewKind = 'plot' | 'picture' | 'json';

/** The views that fit a data format, the best one first. */
export function viewsOf(format: DataFormat): readonly ViewKind[] {
  if (DATA_FORMATS[format].family === 'image') return ['picture', 'json'];
  return seriesOf(format) ? ['plot', 'json'] : ['json'];
}

/** Where the time axis of a plot ends. */
export interface PlotEnd {
  /** This machine's clock; `undefined` for now, which moves. */
  readonly ms: number | undefined;
  /** What stands at the right edge. */
  readonly text: string;
}
