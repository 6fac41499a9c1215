import type { RecordedSession, RecordingEvent } from '@ubii/recording';
import type { PlayedSession } from './recording-messages.ts';
import type { TimeBase } from './recording-time-base.ts';

const OVER: ReadonlySet<string> = new Set(['stopped', 'deleted']);
const ORDER: readonly PlayedSession['presence'][] = ['present', 'ended', 'starts'];

/**
 * All sessions of a recording as they were at a moment. Running sessions come first, then others that are present, those
 * that ended last, and those that start next.
 *
 * @param events in the order in which they happened
 */
export function sessionsNear(
  events: readonly RecordingEvent<'session'>[],
  timeMs: number,
  base: TimeBase,
): PlayedSession[] {
  const byId = new Map<string, { value: RecordedSession; atMs: number }[]>();
  for (const { timeNs, value } of events) {
    const change = { value, atMs: base.toMs(timeNs) };
    byId.set(value.id, [...(byId.get(value.id) ?? []), change]);
  }
  const sessions = [...byId.values()].map((changes): PlayedSession => {
    const before = changes.filter(({ atMs }) => atMs <= timeMs);
    const { value, atMs } = before.at(-1) ?? changes[0]!;
    const wasActive = before.some((one) => !OVER.has(one.value.state));
    const hasEnded = OVER.has(value.state) && wasActive;
    const presence = before.length === 0 ? 'starts' : hasEnded ? 'ended' : 'present';
    return { ...value, presence, sinceMs: atMs };
  });
  return sessions.sort((a, b) => rank(a) - rank(b) || distance(a) - distance(b));
}

const rank = ({ state, presence }: PlayedSession): number =>
  presence === 'present' && state === 'running' ? -1 : ORDER.indexOf(presence);

/** Of those that ended the last one is nearest, of those that start the first one. */
const distance = ({ presence, sinceMs }: PlayedSession): number => {
  if (presence === 'present') return 0;
  return presence === 'starts' ? sinceMs : -sinceMs;
};
