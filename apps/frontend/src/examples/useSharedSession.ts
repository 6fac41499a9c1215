import { SessionState, type Init, type Session } from '@ubii/proto';
import { computed, type ComputedRef, type ShallowRef } from 'vue';
import { refusalSentence, useAttempt } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';
import { isAlive, sessionState } from '../sessions/state/session-state.ts';

/** A session that all clients share. */
export interface SharedSession {
  readonly session: ComputedRef<Session | undefined>;
  /** True while its modules run. */
  readonly isRunning: ComputedRef<boolean>;
  /** True while a service request is pending. */
  readonly isBusy: ComputedRef<boolean>;
  /** Error of the last action, one sentence. */
  readonly trouble: Readonly<ShallowRef<string | undefined>>;
  start(): Promise<void>;
  stop(): Promise<void>;
}

const isLiving = (session: Session): boolean =>
  isAlive(session) || sessionState(session) === SessionState.SESSION_STARTING;

/**
 * Observes, starts and stops a session that is shared by all clients. It continues after the page is left, and restarts
 * with the master.
 * @param isIt returns true for this session
 * @param spec creates the session if there is none
 */
export function useSharedSession(
  isIt: (session: Session) => boolean,
  spec: () => Promise<Init<Session>>,
): SharedSession {
  const { client, sessions } = useConnection();
  const {
    problem: trouble,
    isBusy,
    attempt,
  } = useAttempt({ sentenceOf: refusalSentence, catchesAll: true });

  /** Prefers an active session, then the smallest id, so that all clients choose the same session. */
  function choose(list: readonly Session[]): Session | undefined {
    return list
      .filter(isIt)
      .sort((a, b) => Number(isLiving(b)) - Number(isLiving(a)) || (a.id < b.id ? -1 : 1))[0];
  }
  const session = computed(() => choose(sessions.list.value ?? []));
  const isRunning = computed(() => session.value !== undefined && isAlive(session.value));

  /** Persistent, because no page would start it again after a restart of the master. [SE-24] */
  async function lasting(): Promise<Init<Session>> {
    const session = await spec();
    return { ...session, extension: { ...session.extension, startWithMaster: true } };
  }

  async function ask(): Promise<Session | undefined> {
    return choose((await client.call('sessionRuntimeGetList')).elements);
  }

  async function change(work: () => Promise<void>): Promise<void> {
    if (!isBusy.value) await attempt(work);
  }

  return {
    session,
    isRunning,
    isBusy,
    trouble,
    start: () =>
      change(async () => {
        const there = await ask();
        if (there && isLiving(there)) return sessions.take(there);
        const mine = await client.call(
          'sessionRuntimeStart',
          there ? { id: there.id } : await lasting(),
        );
        // Two clients may have started it at the same time. Both keep the same session.
        const first = await ask();
        if (first && first.id !== mine.id && isLiving(first)) {
          await client.call('sessionRuntimeRemove', { id: mine.id });
          sessions.drop(mine.id);
          sessions.take(first);
        } else sessions.take(mine);
      }),
    stop: () =>
      change(async () => {
        const there = await ask();
        if (there) await client.call('sessionRuntimeStop', { id: there.id });
      }),
  };
}
