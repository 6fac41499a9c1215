import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Init, type Session } from '@ubii/proto';
import { computed, nextTick, onScopeDispose, shallowRef, watch, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useTabNode } from '../../tab-node/useTabNode.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { isAlive } from '../state/session-state.ts';
import { plannedSession, type SessionPlan } from './planned-session.ts';
import { removeOnPageHide } from './remove-on-page-hide.ts';

/** Session that a page starts, changes while it runs, and removes when it is left. */
export interface PageSession {
  /** `undefined` while there is none. */
  readonly session: ComputedRef<Session | undefined>;
  /** True from a new plan until its modules run. */
  readonly isStarting: ComputedRef<boolean>;
  /** Error of the last change, or problem of the session, one sentence. */
  readonly trouble: ComputedRef<string | undefined>;
}

/**
 * Keeps a session as planned while the calling scope is active, also after a restart of the master, which does not
 * store it.
 *
 * @param plan returns `undefined` to end it
 * @param onFailure called when a plan fails; the previous session continues
 */
export function usePageSession(
  plan: () => SessionPlan | undefined,
  onFailure: () => void = () => undefined,
): PageSession {
  const { client, isConnected, sessions, masterId } = useConnection();
  const tab = useTabNode();
  const toasts = useToasts();
  const id = shallowRef<string>();
  const failure = shallowRef<string>();
  let releaseTab: (() => void) | undefined;
  let isOver = false;
  /** Run id of the master that has the session. */
  let runId = '';
  const session = computed(() => sessions.list.value?.find((one) => one.id === id.value));

  async function nodeId(place: string): Promise<string> {
    if (place === 'tab') {
      releaseTab ??= tab.need();
      await tab.whenOn();
      return client.id;
    }
    return place;
  }

  async function apply(): Promise<void> {
    const wanted = plan();
    if (wanted === undefined) return end();
    const node = await nodeId(wanted.place);
    if (isOver) return;
    const known = id.value === undefined ? undefined : sessions.find(id.value);
    const next = plannedSession(wanted, known, node);
    const answer =
      (known && (await update(next))) ??
      (id.value === undefined
        ? await start(next)
        : await startAgain(plannedSession(wanted, undefined, node)));
    sessions.take(answer);
    id.value = answer.id;
    if (isOver) return end();
    if (wanted.place !== 'tab') release();
  }

  /** Returns `undefined` when the master has no such session, which this page may not know yet. */
  async function update(next: Init<Session>): Promise<Session | undefined> {
    try {
      return await client.call('sessionRuntimeUpdate', next);
    } catch (cause) {
      if (!(cause instanceof ServiceError && cause.code === 'not_found')) throw cause;
      const { elements } = await client.call('sessionRuntimeGetList');
      // The session exists; something else, such as the node, does not.
      if (elements.some((one) => one.id === next.id)) throw cause;
      sessions.drop(next.id!);
      return undefined;
    }
  }

  async function start(next: Init<Session>): Promise<Session> {
    runId = masterId.value;
    return client.call('sessionRuntimeStart', next);
  }

  /** Starts the session again after a restart of the master. */
  async function startAgain(next: Init<Session>): Promise<Session> {
    const { id: newest } = await client.call('serverConfiguration');
    if (newest === runId) throw new Error('Another client deleted the session of this page.');
    runId = newest;
    try {
      const started = await client.call('sessionRuntimeStart', next);
      toasts.show(
        `The master was restarted. This page started its session “${started.name}” again.`,
      );
      return started;
    } catch (cause) {
      if (!(cause instanceof ServiceError)) throw cause;
      throw new Error(
        `The restart of the master ended the session. It could not start again: ${cause.message}`,
        { cause },
      );
    }
  }

  function release(): void {
    releaseTab?.();
    releaseTab = undefined;
  }

  function end(): void {
    const gone = id.value;
    id.value = undefined;
    release();
    if (gone === undefined) return;
    sessions.drop(gone);
    client.call('sessionRuntimeRemove', { id: gone }).catch(() => undefined); // it is gone already
  }

  /** Serialises changes, however fast the plan changes. */
  let changes: Promise<void> = Promise.resolve();
  /** Plans are recomputed often; only changes of their content count. */
  const planText = computed(() => JSON.stringify(plan()));
  /** True during a call of `onFailure`: a plan that it ends keeps the error on the screen. */
  let isTelling = false;
  function applySoon(isNeeded: () => boolean = () => true): void {
    const keepsReason = isTelling;
    changes = changes.then(async () => {
      if (!isNeeded()) return;
      if (!keepsReason) failure.value = undefined;
      try {
        await apply();
      } catch (cause) {
        if (cause instanceof ConnectionError) return; // Shown by the shell; retried after reconnecting.
        if (isGone()) id.value = undefined;
        failure.value = cause instanceof Error ? cause.message : String(cause);
        isTelling = true;
        onFailure();
        void nextTick(() => (isTelling = false));
      }
    });
  }
  watch(
    [planText, isConnected],
    ([wanted, connected], [before]) => {
      if (connected && (wanted !== undefined || before !== undefined)) applySoon();
    },
    { immediate: true },
  );
  const isGone = (): boolean => id.value !== undefined && sessions.find(id.value) === undefined;
  watch(sessions.list, (list) => {
    if (list !== undefined && isConnected.value && isGone()) applySoon(isGone);
  });
  onScopeDispose(() => {
    isOver = true;
    end();
  });
  removeOnPageHide(client, () => id.value);

  return {
    session,
    isStarting: computed(
      () => plan() !== undefined && (session.value === undefined || !isAlive(session.value)),
    ),
    trouble: computed(
      () =>
        failure.value ?? session.value?.extension?.problems.find(({ isError }) => isError)?.message,
    ),
  };
}
