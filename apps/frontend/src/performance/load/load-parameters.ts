/** How much, how often, by how many. */
export interface LoadParameters {
  /** Bytes of each record's value. */
  readonly sizeBytes: number;
  /** Connections, each with its own client. */
  readonly clients: number;
  /** Who gets each record: the next client, or all of them. */
  readonly receivers: 'one' | 'all';
  /** Records per second of all clients together, first step. */
  readonly fromHz: number;
  /** Records per second of all clients together, at most. */
  readonly toHz: number;
  /** Each step is so many times the one before. */
  readonly factor: number;
  readonly secondsPerStep: number;
}

/** The rates of a ramp, ascending; the last is `toHz`. */
export function rampOf({ fromHz, toHz, factor }: LoadParameters): number[] {
  const rates: number[] = [];
  for (let rate = fromHz; rate < toHz; rate *= factor) rates.push(roundRate(rate));
  rates.push(toHz);
  return [...new Set(rates)];
}

/** Two digits: `170`, `2 300`. */
function roundRate(rate: number): number {
  const digit = 10 ** Math.max(0, Math.floor(Math.log10(rate)) - 1);
  return Math.round(rate / digit) * digit;
}
