import { StatusProblemSeverity } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { countActive, recordsPerSecond } from '../connection/master-status.ts';
import { useConnection } from '../connection/useConnection.ts';
import { needsAttention, runningOf } from './back/card-words.ts';
import { homeSentence, type HomeSentence } from './home-sentence.ts';

/** How things are, in one sentence. */
export function useHomeSentence(): ComputedRef<HomeSentence> {
  const { master, isConnected, state, clients, sessions } = useConnection();
  return computed(() => {
    const view = master.view.value;
    if (view) {
      // Sessions tell their own errors.
      const found = view.latest.problems.filter(({ code }) => code !== 'session_degraded');
      const isError = (one: (typeof found)[number]): boolean =>
        one.severity === StatusProblemSeverity.ERROR;
      const errors = found.filter(isError).length;
      const running = runningOf(sessions.list.value ?? []);
      return homeSentence({
        active: countActive(view.latest),
        silent: view.latest.clientsInactive,
        errors,
        warnings: found.length - errors,
        running: running.length,
        troubled: running.filter(needsAttention).length,
        recordsPerSecond: recordsPerSecond(view),
      });
    }
    if (master.isUnsupported.value) {
      return {
        is: `Connected. The master has ${clients.list.value?.length ?? 0} clients.`,
        asks: 'This master does not report its state.',
      };
    }
    if (isConnected.value || state.value.status === 'connecting' || state.value.status === 'idle') {
      return { is: 'Connecting to the master…' };
    }
    return { is: 'The master does not answer.', asks: 'Check that it is running.' };
  });
}
