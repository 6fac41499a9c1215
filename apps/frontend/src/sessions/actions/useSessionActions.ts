import { SessionState, type Init, type Session } from '@ubii/proto';
import { counted } from '@ubii/words';
import { until } from '@vueuse/core';
import type { ComputedRef } from 'vue';
import { randomUuid } from '../../connection/random-uuid.ts';
import { useAttemptByKey } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { sessionState, type LifeAction } from '../state/session-state.ts';
import { createSessionCalls, type SessionCalls } from './session-calls.ts';

/** Timeout of a stop, milliseconds: the master stops within 10 s [SE-13], and its announcement may be delayed. */
const STOP_MS = 12_000;

/** Reason why the last action failed, by session id; empty id for a new session. */
export type Failures = ReadonlyMap<string, string>;

export interface SessionActions {
  /** For callers that need the reply, such as a text whose problems are shown beside it. */
  readonly calls: SessionCalls;
  /** Error messages, kept until the next action on the session. */
  readonly failures: ComputedRef<Failures>;
  /** Ids of sessions with a pending request. */
  readonly busy: ComputedRef<ReadonlySet<string>>;
  act(session: Session, action: LifeAction): Promise<void>;
  /** Stops sessions at once, and offers to start them again. */
  stopAll(sessions: readonly Session[]): Promise<void>;
  /** @returns the new session; `undefined` on failure */
  duplicate(session: Session): Promise<Session | undefined>;
  rename(session: Session, name: string): Promise<void>;
  update(session: Session, changes: Init<Session>): Promise<void>;
  /**
   * Removes a session at once, and offers to restore it.
   * @param onRestored called when the user restores it
   * @returns whether it was removed
   */
  remove(session: Session, onRestored?: (session: Session) => void): Promise<boolean>;
  dismiss(id: string): void;
}

export function useSessionActions(): SessionActions {
  const { client, sessions } = useConnection();
  const toasts = useToasts();
  const { problems: failures, busy, attempt, dismiss } = useAttemptByKey();

  async function whenStopped(id: string): Promise<void> {
    const hasEnded = (): boolean => {
      const session = sessions.find(id);
      return session === undefined || sessionState(session) === SessionState.SESSION_STOPPED;
    };
    await until(() => sessions.list.value && hasEnded()).toBe(true, { timeout: STOP_MS });
  }
  const calls = createSessionCalls(client, sessions, whenStopped, randomUuid);

  async function remove(
    session: Session,
    onRestored?: (session: Session) => void,
  ): Promise<boolean> {
    const removed = await attempt(session.id, () => calls.remove(session));
    if (removed === undefined) return false;
    toasts.show(`Deleted ${session.name || 'a session'}`, {
      text: 'Undo',
      run: () =>
        void attempt('', () => calls.restore(removed)).then(
          (restored) => restored && onRestored?.(restored),
        ),
    });
    return true;
  }

  const act = (session: Session, action: LifeAction): Promise<void> =>
    attempt(session.id, () => calls.act(session, action));

  async function stopAll(running: readonly Session[]): Promise<void> {
    await Promise.all(running.map((session) => act(session, 'stop')));
    const stopped = running.filter(({ id }) => !failures.value.has(id));
    if (stopped.length === 0) return;
    toasts.show(`Stopped ${counted(stopped.length, 'session')}`, {
      text: 'Start again',
      run: () => stopped.forEach((session) => void act(session, 'start')),
    });
  }

  return {
    calls,
    failures,
    busy,
    act,
    stopAll,
    duplicate: (session) => attempt(session.id, () => calls.duplicate(session)),
    rename: async (session, name) =>
      void (await attempt(session.id, () => calls.rename(session, name))),
    update: async (session, changes) =>
      void (await attempt(session.id, () => calls.update(session, changes))),
    remove,
    dismiss,
  };
}
