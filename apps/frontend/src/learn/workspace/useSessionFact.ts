import type { ComputedRef } from 'vue';
import type { Session } from '@ubii/proto';
import { useSessionStatistics } from '../../sessions/live/useSessionStatistics.ts';
import { isAlive, sessionState, stateLook } from '../../sessions/state/session-state.ts';
import type { SessionFact } from '../model/facts.ts';

/** Status of a session, and the run rates that its nodes report. */
export function useSessionFact(
  session: ComputedRef<Session | undefined>,
): () => SessionFact | undefined {
  const statistics = useSessionStatistics();
  return () => {
    const now = session.value;
    if (now === undefined) return undefined;
    const isRunning = isAlive(now);
    const names = new Map(now.processingModules.map(({ id, name }) => [id, name]));
    const modules = isRunning ? (statistics.value.get(now.id)?.modules ?? []) : [];
    return {
      name: now.name,
      isRunning,
      state: stateLook(sessionState(now)).word,
      runsPerSecond: new Map(
        modules.map(({ moduleId, runsPerSecond }) => [names.get(moduleId) ?? '', runsPerSecond]),
      ),
    };
  };
}
