import { Pause, Play, Square, StepForward, Workflow } from '@lucide/vue';
import { computed, type ComputedRef } from 'vue';
import { useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { sessionLocation } from '../../locations/session-location.ts';
import type { Command } from '../../page/command.ts';
import { sessionState, stateLook } from '../../sessions/state/session-state.ts';

/** Actions on sessions that are available on every page. */
const INTENTS = {
  start: { verb: 'Start', icon: Play, service: 'sessionRuntimeStart' },
  stop: { verb: 'Stop', icon: Square, service: 'sessionRuntimeStop' },
  pause: { verb: 'Pause', icon: Pause, service: 'sessionPause' },
  resume: { verb: 'Resume', icon: StepForward, service: 'sessionResume' },
} as const;
type Intent = keyof typeof INTENTS;

const isIntent = (action: string): action is Intent => Object.hasOwn(INTENTS, action);

/** Commands to open sessions, and their available actions. */
export function useSessionCommands(): ComputedRef<Command[]> {
  const router = useRouter();
  const { client, sessions } = useConnection();

  /** Failures are shown where the session is shown. */
  async function act(id: string, intent: Intent): Promise<void> {
    await client
      .call(INTENTS[intent].service, { id })
      .catch(() => router.push(sessionLocation(id)));
  }

  return computed(() =>
    (sessions.list.value ?? []).flatMap((session): Command[] => {
      const { id, name } = session;
      const { word, actions } = stateLook(sessionState(session));
      const title = name || 'Unnamed session';
      const open: Command = {
        id: `session ${id}`,
        kind: 'session',
        title,
        detail: word,
        icon: Workflow,
        run: () => void router.push(sessionLocation(id)),
      };
      const intents = actions.filter(isIntent).map((intent): Command => ({
        id: `session ${intent} ${id}`,
        kind: 'session',
        title: `${INTENTS[intent].verb} ${title}`,
        icon: INTENTS[intent].icon,
        run: () => void act(id, intent),
      }));
      return [open, ...intents];
    }),
  );
}
