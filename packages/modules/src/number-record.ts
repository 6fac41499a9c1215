/**
 * A record on an input for a number. Number formats are compatible, so that it can have any of them.
 * [PM-31] Only a type, because callbacks cannot use values outside of them.
 */
export interface NumberRecord {
  readonly double?: number;
  readonly float?: number;
  readonly int32?: number;
}
