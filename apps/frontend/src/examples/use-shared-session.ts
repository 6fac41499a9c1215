import { ConnectionError } from '@ubii/client-web';
import { SessionState, type Init, type Session } from '@ubii/proto';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { isAlive, sessionState } from '../sessions/state/session-state.ts';

/** A session of which there is one for everybody who looks. */
export interface SharedSession {
  readonly session: ComputedRef<Session | undefined>;
  /** Its modules run. */
  readonly isRunning: ComputedRef<boolean>;
  /** A call is on its way. */
  readonly isBusy: Readonly<ShallowRef<boolean>>;
  /** Why the last wish was not fulfilled, one sentence. */
  readonly trouble: Readonly<ShallowRef<string | undefined>>;
  start(): Promise<void>;
  stop(): Promise<void>;
}

const isLiving = (session: Session): boolean =>
  isAlive(session) || sessionState(session) === SessionState.SESSION_STARTING;

/**
 * Follows, starts and stops a session that belongs to no page: who comes later finds it running.
 * @param isIt recognises it among all sessions
 * @param spec makes it, when there is none
 */
export function useSharedSession(
  isIt: (session: Session) => boolean,
  spec: () => Promise<Init<Session>>,
): SharedSession {
  const { client, sessions } = useConnection();
  const isBusy = shallowRef(false);
  const trouble = shallowRef<string>();

  /** The one that counts: what lives before what rests, else the same for everybody, by its id. */
  function choose(list: readonly Session[]): Session | undefined {
    return list
      .filter(isIt)
      .sort((a, b) => Number(isLiving(b)) - Number(isLiving(a)) || (a.id < b.id ? -1 : 1))[0];
  }
  const session = computed(() => choose(sessions.list.value ?? []));
  const isRunning = computed(() => session.value !== undefined && isAlive(session.value));

  async function ask(): Promise<Session | undefined> {
    return choose((await client.call('sessionRuntimeGetList')).elements);
  }

  async function attempt(intent: () => Promise<void>): Promise<void> {
    if (isBusy.value) return;
    isBusy.value = true;
    trouble.value = undefined;
    try {
      await intent();
    } catch (cause) {
      // A lost connection is shown by the shell.
      if (cause instanceof ConnectionError) return;
      trouble.value = cause instanceof Error ? cause.message : String(cause);
    } finally {
      isBusy.value = false;
    }
  }

  return {
    session,
    isRunning,
    isBusy,
    trouble,
    start: () =>
      attempt(async () => {
        const there = await ask();
        if (there && isLiving(there)) return sessions.take(there);
        const mine = await client.call(
          'sessionRuntimeStart',
          there ? { id: there.id } : await spec(),
        );
        // Two people may have pressed Start in the same moment; both leave the same one.
        const first = await ask();
        if (first && first.id !== mine.id && isLiving(first)) {
          await client.call('sessionRuntimeRemove', { id: mine.id });
          sessions.drop(mine.id);
          sessions.take(first);
        } else sessions.take(mine);
      }),
    stop: () =>
      attempt(async () => {
        const there = await ask();
        if (there) await client.call('sessionRuntimeStop', { id: there.id });
      }),
  };
}
