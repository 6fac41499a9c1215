/** The tests of the page. */
export const TEST_KINDS = ['round-trip', 'load', 'session-speed', 'screen'] as const;
export type TestKind = (typeof TEST_KINDS)[number];

/** One measured number. What it means stands in the test's words, not here. */
export interface Figure {
  /** Stable: runs are compared by it. */
  readonly key: string;
  readonly label: string;
  readonly value: number;
  readonly unit: string;
  /** @default 0 */
  readonly decimals?: number;
  /** Which way is good; none for what was chosen or only explains. */
  readonly better?: 'less' | 'more';
}

/** How often which duration came. Bins are those of `histogram.ts`, so that runs can be laid over each other. */
export interface Histogram {
  readonly key: string;
  readonly title: string;
  /** Number of the first bin. */
  readonly firstBin: number;
  readonly counts: readonly number[];
}

/** Values over something: time, rate. */
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
  /** A place on x that is found, such as the knee. */
  readonly mark?: { readonly x: number; readonly text: string };
  readonly isLogarithmic?: boolean;
}

/** What a test found, while it runs or at its end. */
export interface Findings {
  readonly figures: readonly Figure[];
  readonly histograms: readonly Histogram[];
  readonly curves: readonly Curve[];
  /** What a reader must know to judge the numbers, each one sentence or two. */
  readonly notes: readonly string[];
}

export const NO_FINDINGS: Findings = { figures: [], histograms: [], curves: [], notes: [] };

/** Findings of several phases as one. */
export function joinFindings(parts: readonly Findings[]): Findings {
  return {
    figures: parts.flatMap(({ figures }) => figures),
    histograms: parts.flatMap(({ histograms }) => histograms),
    curves: parts.flatMap(({ curves }) => curves),
    notes: [...new Set(parts.flatMap(({ notes }) => notes))],
  };
}
