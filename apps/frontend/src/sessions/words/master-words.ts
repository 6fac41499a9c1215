import type { Session } from '@ubii/proto';
import type { Masters } from '../../connection/useMasters.ts';
import { formatClock } from '../../ui/readouts/format-clock.ts';

/** Where a session runs, among several masters. */
export interface SessionMaster {
  /** Name of its master. */
  readonly label: string;
  /** One sentence or two: the master, and from which one the session came. */
  readonly text: string;
  /** The master is not there, and another one has not taken the session over yet. */
  readonly isLost: boolean;
}

/** Returns where a session runs; `undefined` unless there are several masters. */
export function sessionMaster(
  { extension }: Pick<Session, 'extension'>,
  masters: Pick<Masters, 'labelOf' | 'isGone'>,
): SessionMaster | undefined {
  const { masterId = '', movedFrom = '', movedMs = 0 } = extension ?? {};
  const label = masters.labelOf(masterId);
  if (label === '') return undefined;
  if (masters.isGone(masterId)) {
    const text = `Its master ${label} is lost. Another master takes the session over, or the same when it is back.`;
    return { label, text, isLost: true };
  }
  if (movedMs === 0) return { label, text: `On the master ${label}.`, isLost: false };
  const from = movedFrom === '' ? 'a lost master' : `the lost master ${movedFrom}`;
  const text = `On the master ${label}. Taken over from ${from} at ${formatClock(movedMs)}.`;
  return { label, text, isLost: false };
}
