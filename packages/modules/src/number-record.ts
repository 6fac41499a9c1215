/**
 * A record on an input for a number: number formats fit each other, so it may be any of them. [PM-31]
 * A type only: callbacks cannot reach values outside of them.
 */
export interface NumberRecord {
  readonly double?: number;
  readonly float?: number;
  readonly int32?: number;
}
