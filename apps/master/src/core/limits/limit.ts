export const KIB = 1024;
export const MIB = 1024 * KIB;

/** A limit and its description for users [EX-35]. */
export interface LimitInfo {
  readonly value: number;
  /** Unit of the value. */
  readonly unit: string;
  /** Group in lists of limits. */
  readonly group: LimitGroup;
  /** Subject of the limit, and the reason for its value. */
  readonly reason: string;
}

/** Groups of limits, in display order. */
export const LIMIT_GROUPS = [
  'messages',
  'texts',
  'storage',
  'subscriptions',
  'rates',
  'queues',
  'sessions',
  'time',
  'statistics',
] as const;

export type LimitGroup = (typeof LIMIT_GROUPS)[number];

export function limit(value: number, unit: string, group: LimitGroup, reason: string): LimitInfo {
  return { value, unit, group, reason };
}
