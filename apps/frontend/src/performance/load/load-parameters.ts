/** Parameters of the load test. */
export interface LoadParameters {
  /** Size of each record's value, bytes. */
  readonly sizeBytes: number;
  /** Number of connections, each with its own client. */
  readonly clients: number;
  /** Receivers of each record: the next client, or all. */
  readonly receivers: 'one' | 'all';
  /** Total rate of all clients in the first step, records per second. */
  readonly fromHz: number;
  /** Highest total rate of all clients, records per second. */
  readonly toHz: number;
  /** Ratio of the rates of consecutive steps. */
  readonly factor: number;
  readonly secondsPerStep: number;
}

/** Returns the rates of a ramp, ascending; the last is `toHz`. */
export function rampOf({ fromHz, toHz, factor }: LoadParameters): number[] {
  const rates: number[] = [];
  for (let rate = fromHz; rate < toHz; rate *= factor) rates.push(roundRate(rate));
  rates.push(toHz);
  return [...new Set(rates)];
}

/** Rounds to two significant digits: `170`, `2 300`. */
function roundRate(rate: number): number {
  const digit = 10 ** Math.max(0, Math.floor(Math.log10(rate)) - 1);
  return Math.round(rate / digit) * digit;
}
