import type { ClientClock } from '@ubii/proto';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { Readout } from '../../ui/readouts/readout.ts';
import type { ClientView } from './client-view.ts';

/** Clock offset that a client has measured; `undefined` when it reports none. [TS-10] */
export function clockOf({ activity }: ClientView): ClientClock | undefined {
  return activity?.connected ? activity.clock : undefined;
}

/** Time by which the client's clock is ahead of the master's; negative: behind. */
export function clockAhead(clock: ClientClock): Readout {
  const aheadMs = -clock.offsetMs;
  const { value, unit } = inUnit(aheadMs);
  // Offsets within the error are shown as zero.
  if (Math.abs(aheadMs) <= clock.errorMs) return { digits: '0', unit: 'ms' };
  return { digits: value > 0 ? `+${formatted(value, unit)}` : formatted(value, unit), unit };
}

/** Error of the offset, such as `±1.4 ms`. */
export function clockError({ errorMs }: ClientClock): string {
  const { value, unit } = inUnit(errorMs);
  return `±${formatNumber(value, value < 10 ? 1 : 0)} ${unit}`;
}

function formatted(value: number, unit: string): string {
  return formatNumber(value, unit === 'ms' ? 0 : 1);
}

function inUnit(ms: number): { value: number; unit: string } {
  const size = Math.abs(ms);
  if (size < 999.5) return { value: ms, unit: 'ms' };
  if (size < 120_000) return { value: ms / 1_000, unit: 's' };
  return size < 7_200_000
    ? { value: ms / 60_000, unit: 'min' }
    : { value: ms / 3_600_000, unit: 'h' };
}
