/**
 * Returns the last line that a master writes in the terminal.
 *
 * @param sessions how many sessions start again with the master [SE-24]
 */
export function formatFarewell(sessions: number): string {
  if (sessions === 0) return 'Stopped.';
  const subject = sessions === 1 ? '1 session' : `${sessions} sessions`;
  return `Stopped. ${subject} will start again with the master.`;
}
