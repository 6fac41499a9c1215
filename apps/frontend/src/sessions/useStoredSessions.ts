import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Session } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { usePoll } from '../connection/poll.ts';
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
    try {
      stored.value = (await client.call('sessionDatabaseGetList')).elements;
      isKnown.value = true;
    } catch (cause) {
      // Original masters may refuse; a lost connection is shown elsewhere.
      if (!(cause instanceof ConnectionError || cause instanceof ServiceError)) throw cause;
      if (cause instanceof ServiceError) isKnown.value = true;
    }
  }
  usePoll(refresh, INTERVAL_MS, isConnected);
  return { list: stored, isKnown, refresh };
}
