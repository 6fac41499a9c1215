import { keepPageSession, type PageLife, type PageSession } from './page-session.ts';
import { followLastingSession, type LastingLife, type LastingSession } from './lasting-session.ts';

/**
 * Runs a session that a page needs, while the calling scope is active.
 *
 * | life     | starts             | ends                              | after a restart of the master |
 * | -------- | ------------------ | --------------------------------- | ----------------------------- |
 * | `page`   | with its plan      | without a plan, and with the page | the page starts it again      |
 * | `shared` | when a user starts | when a user stops it              | the master starts it again    |
 * | `stored` | when a user starts | when a user stops it; its file stays | the master starts it again |
 *
 * Other jobs: `useOpenedSession` shows one session by its id; a lesson about the graph gives its session to the editor, which
 * changes it (`learn/workspace/GraphWorkspace.vue`); a speed test waits for each step of its session, which belongs to a client
 * of its own (`performance/session-speed/run-speed.ts`); the master runs recorded sessions (`recordings/compare/useRerun.ts`).
 */
export function useOwnedSession(options: PageLife): PageSession;
export function useOwnedSession(options: LastingLife): LastingSession;
export function useOwnedSession(options: PageLife | LastingLife): PageSession | LastingSession {
  return options.life === 'page' ? keepPageSession(options) : followLastingSession(options);
}
