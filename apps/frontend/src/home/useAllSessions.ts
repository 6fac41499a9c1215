import type { Session } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { withStored } from '../sessions/list/session-rows.ts';
import { useStoredSessions } from '../sessions/useStoredSessions.ts';

/** All sessions of the master, stored ones included; `undefined` until both lists are known. */
export function useAllSessions(): ComputedRef<readonly Session[] | undefined> {
  const { sessions } = useConnection();
  const stored = useStoredSessions();
  return computed(() =>
    sessions.list.value && stored.isKnown.value
      ? withStored(sessions.list.value, stored.list.value)
      : undefined,
  );
}
