import type { Findings, TestKind } from '../measure/findings.ts';

/** Parameter of a run. */
export interface Parameter {
  readonly key: string;
  readonly label: string;
  readonly value: string | number;
  readonly unit?: string;
}

/** Circumstance that may explain a figure: browser, master, load. */
export interface Circumstance {
  readonly key: string;
  readonly label: string;
  readonly value: string;
}

/** Reason for the end of a run. Measurements until then count in each case. */
export type TestEnd = 'complete' | 'stopped' | 'disconnected';

/** Run of a test, as stored, compared and exported. */
export interface TestResult {
  readonly id: string;
  readonly kind: TestKind;
  /** Name, editable; by default the test and the time. */
  readonly name: string;
  /** Epoch milliseconds, this computer's clock. */
  readonly startedMs: number;
  readonly durationMs: number;
  readonly ended: TestEnd;
  readonly parameters: readonly Parameter[];
  readonly circumstances: readonly Circumstance[];
  readonly findings: Findings;
}
