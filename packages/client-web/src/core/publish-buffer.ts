/** How one record is published. */
export interface PublishOptions {
  /** Send at once, with what is waiting before it, and not with the next flush. @default false */
  readonly immediate?: boolean;
  /** Timestamp of the record: milliseconds since the Unix epoch. @default now */
  readonly timestampMs?: number;
}
