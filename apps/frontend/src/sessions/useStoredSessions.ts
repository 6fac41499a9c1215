import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Session } from '@ubii/proto';
import { shallowRef, type ShallowRef } from 'vue';
import { usePoll } from '../connection/poll.ts';
import { useConnection } from '../connection/useConnection.ts';

/** Files may be changed by hand at any time, which nothing announces. [SE-23] */
const INTERVAL_MS = 3000;

/** The sessions on the master's disk. */
export interface StoredSessions {
  readonly list: Readonly<ShallowRef<readonly Session[]>>;
  /** The master has answered once. */
  readonly isKnown: Readonly<ShallowRef<boolean>>;
  refresh(): Promise<void>;
}

/** Follows them while the calling scope lives. */
export function useStoredSessions(): StoredSessions {
  const { client, isConnected } = useConnection();
  const stored = shallowRef<readonly Session[]>([]);
  const isKnown = shallowRef(false);
  async function refresh(): Promise<void> {
    try {
      stored.value = (await client.call('sessionDatabaseGetList')).elements;
      isKnown.value = true;
    } catch (cause) {
      // Original masters may refuse; a failed link is shown elsewhere.
      if (!(cause instanceof ConnectionError || cause instanceof ServiceError)) throw cause;
      if (cause instanceof ServiceError) isKnown.value = true;
    }
  }
  usePoll(refresh, INTERVAL_MS, isConnected);
  return { list: stored, isKnown, refresh };
}
