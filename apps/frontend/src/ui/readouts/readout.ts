/** A number as it is shown: the digits, and the unit drawn dimmer behind them. */
export interface Readout {
  readonly digits: string;
  readonly unit?: string;
}

/** Shown where there is no value. */
export const NO_VALUE: Readout = { digits: '–' };
