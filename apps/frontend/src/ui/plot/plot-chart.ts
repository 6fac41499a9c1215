/** Line of a plot. Default colour: text colour, because measurements belong to no data format family. */
export interface PlotLine {
  readonly label: string;
  /** One per `x`; `null` is a gap. */
  readonly values: readonly (number | null)[];
  /** @default 'line' */
  readonly kind?: 'line' | 'steps' | 'points' | 'both';
  readonly stroke?: PlotStroke;
}

/** Line style: shade and dash, never shade alone. `color` is a style token such as `--family-vector`. */
export interface PlotStroke {
  /** @default '--ink-1' */
  readonly color?: `--${string}`;
  readonly dash?: readonly number[];
}

/** Axis of a plot. */
export interface PlotAxis {
  readonly label: string;
  /** Shown after a value at the reading line. */
  readonly unit?: string;
  /** @default false */
  readonly isLogarithmic?: boolean;
  /** Starts at 0, to show amounts instead of changes. @default true for y, false for x */
  readonly fromZero?: boolean;
  /** @default two to three digits */
  readonly format?: (value: number) => string;
}

/** Vertical line at an x value, with a label. */
export interface PlotMark {
  readonly x: number;
  readonly text: string;
}

/** Content of a plot. */
export interface PlotChart {
  /** Ascending. */
  readonly x: readonly number[];
  readonly lines: readonly PlotLine[];
  readonly xAxis: PlotAxis;
  readonly yAxis: PlotAxis;
  readonly marks?: readonly PlotMark[];
}

/** Styles for the lines of a plot, in order: shade and dash differ. */
export const PLOT_STROKES: readonly PlotStroke[] = [
  { color: '--ink-1' },
  { color: '--ink-3', dash: [6, 3] },
  { color: '--ink-2', dash: [2, 3] },
  { color: '--ink-3', dash: [10, 3, 2, 3] },
  { color: '--control' },
  { color: '--control', dash: [4, 2] },
];

export function plotStroke(index: number): PlotStroke {
  return PLOT_STROKES[index % PLOT_STROKES.length]!;
}
