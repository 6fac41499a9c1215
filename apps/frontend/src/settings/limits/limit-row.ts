import type { Limit } from '@ubii/proto';
import { capitalised } from '@ubii/words';
import { formatBytes } from '../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { Readout } from '../../ui/readouts/readout.ts';

/** Share from which a limit counts as almost reached. */
export const NEAR_SHARE = 0.8;

/** Row of a limit. */
export interface LimitRow {
  readonly limit: Limit;
  /** Name in words: `Retained bytes`. */
  readonly words: string;
  readonly allowed: Readout;
  /** `undefined` when the master does not measure it. */
  readonly used: Readout | undefined;
  /** Used share, 0 to 1; `undefined` when not measured. */
  readonly share: number | undefined;
  /** `near` and `met` are highlighted. */
  readonly state: 'fine' | 'near' | 'met';
  /** Command-line flag that changes it, for copying. */
  readonly flag: string;
}

/** Formats `1024 bytes` and `30 000 ms` in larger units; other units unchanged. */
export function limitReadout(value: number, unit: string): Readout {
  const per = unit.endsWith('/s') ? '/s' : '';
  if (unit === `bytes${per}`) return formatBytes(value, `B${per}`);
  if (unit === 'ms' && value >= 60_000) {
    return { digits: formatNumber(value / 60_000, value % 60_000 ? 1 : 0), unit: 'min' };
  }
  if (unit === 'ms' && value >= 1000) {
    return { digits: formatNumber(value / 1000, value % 1000 ? 1 : 0), unit: 's' };
  }
  return { digits: formatNumber(value, Number.isInteger(value) ? 0 : 1), unit };
}

/** The same for the usage, without the unit if the limit beside it has the same. */
function useReadout(value: number, unit: string): Readout {
  const { digits, unit: shown } = limitReadout(value, unit);
  return shown === unit ? { digits } : limitReadout(value, unit);
}

export function limitRow(limit: Limit): LimitRow {
  const { name, value, unit, use, hits } = limit;
  const share = use && value > 0 ? use.value / value : undefined;
  const isFull = share !== undefined && share >= 1;
  return {
    limit,
    words: capitalised(name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`)),
    allowed: limitReadout(value, unit),
    used: use && useReadout(use.value, unit),
    share,
    state: isFull || hits > 0 ? 'met' : (share ?? 0) >= NEAR_SHARE ? 'near' : 'fine',
    flag: `--limits ${name}=${Math.min(value * 2, Number.MAX_SAFE_INTEGER)}`,
  };
}

/** Rows under a heading. */
export interface LimitGroupRows {
  readonly title: string;
  readonly rows: readonly LimitRow[];
}

/**
 * Returns the rows that match a search, grouped by heading; limits that are reached or almost reached come first, under
 * a separate heading.
 */
export function groupLimits(limits: readonly Limit[], search: string): LimitGroupRows[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  const rows = limits.map(limitRow).filter(({ limit, words: name }) => {
    const text = `${limit.name} ${name} ${limit.reason} ${limit.unit} ${limit.group}`.toLowerCase();
    return words.every((word) => text.includes(word));
  });
  const loud = rows
    .filter(({ state }) => state !== 'fine')
    .sort((a, b) => (b.share ?? 0) - (a.share ?? 0));
  const groups = new Map<string, LimitRow[]>();
  for (const row of rows) {
    if (row.state !== 'fine') continue;
    groups.set(row.limit.group, [...(groups.get(row.limit.group) ?? []), row]);
  }
  const quiet = [...groups].map(([group, of]) => ({ title: capitalised(group), rows: of }));
  return loud.length === 0 ? quiet : [{ title: 'Reached or almost reached', rows: loud }, ...quiet];
}
