import type { RestoreReport } from '../../core/sessions/restored-sessions.ts';
import { countSessions, listNames, MAX_NAMES, printable } from './session-words.ts';

const MAX_REASON_CHARACTERS = 240;

/** Returns the lines on the sessions that this master started again, with a reason for each that does not run [SE-24]. */
export function formatRestored({ running, others }: RestoreReport): string {
  const lines = [
    ...(running.length === 0
      ? []
      : [`The master started ${countSessions(running)} again: ${listNames(running)}`]),
    ...others
      .slice(0, MAX_NAMES)
      .map(
        ({ name, reason }) =>
          `${listNames([name])} does not run as before: ${printable(reason, MAX_REASON_CHARACTERS)}`,
      ),
    ...(others.length > MAX_NAMES
      ? [`${others.length - MAX_NAMES} more do not run as before. The Sessions page lists them.`]
      : []),
  ];
  return lines.map((line) => `  ${line}\n`).join('');
}
