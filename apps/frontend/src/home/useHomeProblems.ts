import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { homeProblems, type HomeProblem } from './home-problems.ts';

/** All problems of master, clients and sessions, errors first. */
export function useHomeProblems(): ComputedRef<readonly HomeProblem[]> {
  const { master, clients, sessions } = useConnection();
  return computed(() =>
    homeProblems(master.view.value?.latest.problems ?? [], {
      findClient: clients.find,
      ownName: clients.ownName,
      sessions: sessions.list.value ?? [],
    }),
  );
}
