/** Least distance of two stamps, milliseconds: what a double of the time since 1970 resolves, and more. */
const STEP_MS = 0.001;

/** Place of a record among all records of its topic, on all masters. [CU-12] */
export interface Stamped {
  readonly stamp: number;
  /** Where it was published. */
  readonly masterId: string;
}

/** The stamp of a record that is published now: after all that its topic has had here. */
export function nextStamp(lastStamp: number, nowMs: number): number {
  return nowMs > lastStamp ? nowMs : lastStamp + STEP_MS;
}

/** Whether a record replaces a value. Of equal stamps the greater id counts, as on every other master. */
export function isNewer(record: Stamped & { readonly isValue: boolean }, value: Stamped): boolean {
  if (record.stamp !== value.stamp) return record.stamp > value.stamp;
  // Records of one turn bear the stamp of the last of them; a value with it is that value again.
  return record.masterId === value.masterId ? !record.isValue : record.masterId > value.masterId;
}
