import type { Findings, TestKind } from '../measure/findings.ts';

/** What was chosen for a run. */
export interface Parameter {
  readonly key: string;
  readonly label: string;
  readonly value: string | number;
  readonly unit?: string;
}

/** What was so, and may explain a number: browser, master, load. */
export interface Circumstance {
  readonly key: string;
  readonly label: string;
  readonly value: string;
}

/** How a run ended. What it measured until then counts in each case. */
export type TestEnd = 'complete' | 'stopped' | 'disconnected';

/** One run of a test, as it is kept, compared and exported. */
export interface TestResult {
  readonly id: string;
  readonly kind: TestKind;
  /** People's own; at first the test and the moment. */
  readonly name: string;
  /** Milliseconds since the Unix epoch, this machine's clock. */
  readonly startedMs: number;
  readonly durationMs: number;
  readonly ended: TestEnd;
  readonly parameters: readonly Parameter[];
  readonly circumstances: readonly Circumstance[];
  readonly findings: Findings;
}
