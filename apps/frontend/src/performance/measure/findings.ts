import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { Readout } from '../../ui/readouts/readout.ts';

/** The tests of the page. */
export const TEST_KINDS = ['round-trip', 'load', 'session-speed', 'screen'] as const;
export type TestKind = (typeof TEST_KINDS)[number];

/** A measured number. Its explanation is in the test's texts. */
export interface Figure {
  /** Stable, because runs are compared by it. */
  readonly key: string;
  readonly label: string;
  readonly value: number;
  readonly unit: string;
  /** @default 0 */
  readonly decimals?: number;
  /** Direction of improvement; undefined for parameters and explanatory figures. */
  readonly better?: 'less' | 'more';
}

/** A value as it is shown, the same in tables and sentences: from 1 on, with one decimal at most. */
export function figureReadout({ value, unit, decimals = 0 }: Figure): Readout {
  const digits = formatNumber(value, Math.abs(value) >= 1 ? Math.min(decimals, 1) : decimals);
  return unit === '' ? { digits } : { digits, unit };
}

/** Histogram of durations. All have the bins of `histogram.ts`, so that runs can be overlaid. */
export interface Histogram {
  readonly key: string;
  readonly title: string;
  /** Index of the first bin. */
  readonly firstBin: number;
  readonly counts: readonly number[];
}

/** Values over time or rate. */
export interface Curve {
  readonly key: string;
  readonly title: string;
  readonly x: { readonly label: string; readonly unit: string; readonly values: readonly number[] };
  readonly y: { readonly label: string; readonly unit: string };
  readonly lines: readonly {
    readonly key: string;
    readonly label: string;
    readonly values: readonly (number | null)[];
  }[];
  /** Marked x value, such as the knee. */
  readonly mark?: { readonly x: number; readonly text: string };
  readonly isLogarithmic?: boolean;
}

/** Findings of a test, while it runs or at its end. */
export interface Findings {
  readonly figures: readonly Figure[];
  readonly histograms: readonly Histogram[];
  readonly curves: readonly Curve[];
  /** Notes for interpreting the figures, one or two sentences each. */
  readonly notes: readonly string[];
}

export const NO_FINDINGS: Findings = { figures: [], histograms: [], curves: [], notes: [] };

/** Joins the findings of several phases. */
export function joinFindings(parts: readonly Findings[]): Findings {
  return {
    figures: parts.flatMap(({ figures }) => figures),
    histograms: parts.flatMap(({ histograms }) => histograms),
    curves: parts.flatMap(({ curves }) => curves),
    notes: [...new Set(parts.flatMap(({ notes }) => notes))],
  };
}
