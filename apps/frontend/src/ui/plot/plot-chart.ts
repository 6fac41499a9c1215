/** How a line is drawn. Without a family it is ink: what is measured is no data of a topic. */
export interface PlotLine {
  readonly label: string;
  /** One for each `x`; `null` is a gap. */
  readonly values: readonly (number | null)[];
  /** @default 'line' */
  readonly kind?: 'line' | 'steps' | 'points' | 'both';
  readonly stroke?: PlotStroke;
}

/** Distinguished by shade and dash, never by shade alone. `color` is a token such as `--family-vector`. */
export interface PlotStroke {
  /** @default '--ink-1' */
  readonly color?: `--${string}`;
  readonly dash?: readonly number[];
}

/** An axis of a plot. */
export interface PlotAxis {
  readonly label: string;
  /** Behind the number where one is read. */
  readonly unit?: string;
  /** @default false */
  readonly isLogarithmic?: boolean;
  /** Axes that begin at 0 say how much; others only how it changes. @default true for y, false for x */
  readonly fromZero?: boolean;
  /** @default two to three digits */
  readonly format?: (value: number) => string;
}

/** A line across the plot at one x, with a word. */
export interface PlotMark {
  readonly x: number;
  readonly text: string;
}

/** What a plot shows. */
export interface PlotChart {
  /** Ascending. */
  readonly x: readonly number[];
  readonly lines: readonly PlotLine[];
  readonly xAxis: PlotAxis;
  readonly yAxis: PlotAxis;
  readonly marks?: readonly PlotMark[];
}

/** Strokes for the lines of one plot, in order: shade and dash differ. */
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
