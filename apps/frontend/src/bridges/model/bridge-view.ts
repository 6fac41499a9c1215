import type { DirectionRates } from './bridge-rates.ts';
import type { BridgeReport } from './bridge-report.ts';

/** A bridge as far as this page knows it. */
export interface BridgeView {
  readonly id: string;
  readonly name: string;
  /** The other system: kind, host and port, or the name in the mapping file. */
  readonly system: string;
  /** False for one that has left since the page was opened. */
  readonly isHere: boolean;
  /** The newest; `undefined` before the first. */
  readonly report: BridgeReport | undefined;
  /** Records per second, by name of the mapping. */
  readonly rates: ReadonlyMap<string, DirectionRates>;
  readonly total: DirectionRates;
}
