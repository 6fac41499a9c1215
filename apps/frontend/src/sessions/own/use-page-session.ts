import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Session } from '@ubii/proto';
import { computed, onScopeDispose, shallowRef, watch, type ComputedRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import { useTabNode } from '../../tab-node/useTabNode.ts';
import { isAlive } from '../state/session-state.ts';
import { plannedSession, type SessionPlan } from './planned-session.ts';
import { removeOnPageHide } from './remove-on-page-hide.ts';

/** A session that a page starts, changes while it runs, and ends when it is left. */
export interface PageSession {
  /** `undefined` while there is none. */
  readonly session: ComputedRef<Session | undefined>;
  /** True from a plan until its modules run. */
  readonly isStarting: ComputedRef<boolean>;
  /** Error of the last change, or what is wrong with the session, one sentence. */
  readonly trouble: ComputedRef<string | undefined>;
}

/**
 * Keeps a session as planned while the calling scope lives.
 *
 * @param plan `undefined` ends it
 * @param onFailure a plan could not be carried out; what ran before goes on
 */
export function usePageSession(
  plan: () => SessionPlan | undefined,
  onFailure: () => void = () => undefined,
): PageSession {
  const { client, isConnected, sessions } = useConnection();
  const tab = useTabNode();
  const id = shallowRef<string>();
  const failure = shallowRef<string>();
  let releaseTab: (() => void) | undefined;
  let isOver = false;
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
    const answer = known
      ? await client.call('sessionRuntimeUpdate', next)
      : await client.call('sessionRuntimeStart', next);
    sessions.take(answer);
    id.value = answer.id;
    if (isOver) return end();
    if (wanted.place !== 'tab') release();
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

  /** One change after the other, however fast the plan changes. */
  let changes: Promise<void> = Promise.resolve();
  /** Plans are made anew with everything they are made of; only what they say differently counts. */
  const planText = computed(() => JSON.stringify(plan()));
  watch(
    [planText, isConnected],
    ([wanted, connected], [before]) => {
      if (!connected || (wanted === undefined && before === undefined)) return;
      changes = changes.then(async () => {
        failure.value = undefined;
        try {
          await apply();
        } catch (cause) {
          if (cause instanceof ConnectionError) return; // shown by the shell, tried again after it
          if (cause instanceof ServiceError && cause.code === 'not_found') id.value = undefined;
          failure.value = cause instanceof Error ? cause.message : String(cause);
          onFailure();
        }
      });
    },
    { immediate: true },
  );
  onScopeDispose(() => {
    isOver = true;
    end();
  });
  removeOnPageHide(() => id.value);

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
