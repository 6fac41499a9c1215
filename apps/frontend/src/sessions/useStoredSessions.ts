import { ServiceError, type Session } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { usePoll } from '../connection/poll.ts';
import { tryRequest } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';

/** Interval of requests, milliseconds: manual changes of files are not announced. [SE-23] */
const INTERVAL_MS = 3000;

/** Sessions stored on the master's disk. */
export interface StoredSessions {
  readonly list: Readonly<ShallowRef<readonly Session[]>>;
  /** True after the first reply of the master. */
  readonly isKnown: Readonly<ShallowRef<boolean>>;
  refresh(): Promise<void>;
}

/** Observes the stored sessions while the calling scope is active. */
export function useStoredSessions(): StoredSessions {
  const { client, isConnected } = useConnection();
  const stored = shallowRef<readonly Session[]>([]);
  const isKnown = shallowRef(false);
  async function refresh(): Promise<void> {
    const reply = await tryRequest(
      () => client.call('sessionDatabaseGetList'),
      // Original masters may refuse; a lost connection is shown elsewhere.
      (error) => (isKnown.value ||= error instanceof ServiceError),
    );
    if (reply === undefined) return;
    stored.value = reply.elements;
    isKnown.value = true;
  }
  usePoll(refresh, INTERVAL_MS, isConnected);
  return { list: stored, isKnown, refresh };
}
