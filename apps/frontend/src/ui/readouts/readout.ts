/** Formatted number: digits, and a unit that is dimmed. */
export interface Readout {
  readonly digits: string;
  readonly unit?: string;
}

/** Placeholder for a missing value. */
export const NO_VALUE: Readout = { digits: '–' };
