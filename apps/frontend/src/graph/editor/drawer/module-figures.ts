import type { ModuleStatistics } from '@ubii/proto';
import { formatBytes } from '../../../ui/readouts/format-bytes.ts';
import { formatNumber } from '../../../ui/readouts/format-number.ts';
import { formatRate } from '../../../ui/readouts/format-rate.ts';
import { formatRunTime } from '../../../ui/readouts/format-time.ts';
import { NO_VALUE, type Readout } from '../../../ui/readouts/readout.ts';

/** Names of the figures of a module, in their order. */
export const FIGURES = [
  'Runs/s',
  'p50',
  'p95',
  'Overruns',
  'Errors',
  'Refused',
  'Restarts',
  'Memory',
] as const;

/** A figure of a module as text, with its emphasis. */
export interface ModuleFigure extends Readout {
  readonly tone: 'plain' | 'soft' | 'quiet' | 'warn' | 'err';
}

/**
 * Returns the figures of a module.
 * @param of undefined while nothing was reported
 */
export function moduleFigures(
  of: ModuleStatistics | undefined,
): Readonly<Record<(typeof FIGURES)[number], ModuleFigure>> {
  const time = (ms: number | undefined): Readout =>
    of === undefined || of.runsPerSecond === 0 || ms === undefined ? NO_VALUE : formatRunTime(ms);
  const count = (value: number | undefined, bad: 'warn' | 'err'): ModuleFigure => ({
    ...(value === undefined ? NO_VALUE : { digits: formatNumber(value) }),
    tone: value ? bad : 'quiet',
  });
  return {
    'Runs/s': { ...(of ? { digits: formatRate(of.runsPerSecond) } : NO_VALUE), tone: 'plain' },
    p50: { ...time(of?.runP50Ms), tone: 'plain' },
    p95: { ...time(of?.runP95Ms), tone: 'soft' },
    Overruns: count(of?.overruns, 'warn'),
    Errors: count(of?.errors, 'err'),
    Refused: count(of?.outputsRefused, 'warn'),
    Restarts: count(of?.restarts, 'warn'),
    Memory: { ...(of?.memoryBytes ? formatBytes(of.memoryBytes) : NO_VALUE), tone: 'soft' },
  };
}
