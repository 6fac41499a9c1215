import { formatBytes } from '../../ui/readouts/format-bytes.ts';

/** Limits of a topic's history: records that are older or exceed the memory are dropped. */
export interface HistoryLimits {
  readonly maxAgeMs: number;
  /** Memory for points of charts and for records, half each. */
  readonly maxBytes: number;
}

const MINUTE_MS = 60_000;
const MEGABYTE = 1_000_000;

export const KEPT_MINUTES: readonly number[] = [1, 2, 5, 10];
export const KEPT_MEGABYTES: readonly number[] = [4, 16, 64, 256];

/** Ten minutes of five numbers at 60 Hz need about 2 MB, with their records 15 MB. */
export const DEFAULT_LIMITS: HistoryLimits = {
  maxAgeMs: 10 * MINUTE_MS,
  maxBytes: 64 * MEGABYTE,
};

/** @param stored value from an earlier visit, not validated */
export function readLimits(stored: unknown): HistoryLimits {
  if (typeof stored !== 'object' || stored === null) return DEFAULT_LIMITS;
  const { minutes, megabytes } = stored as { minutes?: unknown; megabytes?: unknown };
  return {
    maxAgeMs: oneOf(KEPT_MINUTES, minutes, DEFAULT_LIMITS.maxAgeMs / MINUTE_MS) * MINUTE_MS,
    maxBytes: oneOf(KEPT_MEGABYTES, megabytes, DEFAULT_LIMITS.maxBytes / MEGABYTE) * MEGABYTE,
  };
}

export function storedLimits({ maxAgeMs, maxBytes }: HistoryLimits): {
  readonly minutes: number;
  readonly megabytes: number;
} {
  return { minutes: maxAgeMs / MINUTE_MS, megabytes: maxBytes / MEGABYTE };
}

/** `10 min or 64 MB of each topic, whichever comes first`. */
export function limitsInWords({ maxAgeMs, maxBytes }: HistoryLimits): string {
  const { digits, unit } = formatBytes(maxBytes, 'B');
  return `${maxAgeMs / MINUTE_MS} min or ${digits} ${unit ?? ''} of each topic, whichever comes first`;
}

const oneOf = (choices: readonly number[], value: unknown, otherwise: number): number =>
  choices.find((choice) => choice === value) ?? otherwise;
