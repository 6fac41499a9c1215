import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Session } from '@ubii/proto';
import { computed, shallowRef, toValue, watch, type ComputedRef, type MaybeRefOrGetter } from 'vue';
import { useConnection } from '../connection/useConnection.ts';
import { useSessionActions } from './actions/useSessionActions.ts';
import { sessionAtRest } from './state/session-state.ts';

/** The session of an address. */
export interface OpenedSession {
  /** As the master has it, or had it last. */
  readonly session: ComputedRef<Session | undefined>;
  /** The master has no session of this id, neither open nor stored. */
  readonly isGone: ComputedRef<boolean>;
  /** Why a stored session cannot be opened. */
  readonly failure: ComputedRef<string | undefined>;
  /** How often it was opened here: after a restart of the master its revisions may have gone back. */
  readonly openings: ComputedRef<number>;
}

/**
 * Follows the session of an id, and opens it at the master when it is only stored. [SE-27]
 * @param isNew the id was made here, and the master need not be asked
 */
export function useOpenedSession(
  id: MaybeRefOrGetter<string>,
  isNew: MaybeRefOrGetter<boolean> = false,
): OpenedSession {
  const { client, sessions, isConnected } = useConnection();
  const { calls } = useSessionActions();
  const listed = computed(() => sessions.list.value?.find((one) => one.id === toValue(id)));
  const known = shallowRef<Session>();
  /** What the master answered when it was asked for a session that it did not list. */
  const answer = shallowRef<'gone' | { readonly failure: string }>();
  const openings = shallowRef(0);

  /** Who may only look gets it as it is stored. */
  async function readStored(sessionId: string): Promise<Session> {
    return client.call('sessionRuntimeGet', { id: sessionId });
  }

  async function open(sessionId: string): Promise<void> {
    try {
      const opened = await calls.open(sessionId).catch((cause: unknown) => {
        const isViewer = cause instanceof ServiceError && cause.code === 'permission_denied';
        if (!isViewer) throw cause;
        return readStored(sessionId);
      });
      if (sessionId !== toValue(id)) return;
      known.value = opened;
      openings.value += 1;
    } catch (cause) {
      // After a reconnect it is asked again.
      if (cause instanceof ConnectionError || sessionId !== toValue(id)) return;
      if (!(cause instanceof ServiceError)) throw cause;
      answer.value = cause.code === 'not_found' ? 'gone' : { failure: cause.message };
    }
  }

  watch(
    [() => toValue(id), listed],
    ([nextId, next], [idBefore]) => {
      if (known.value?.id !== nextId) known.value = undefined;
      if (next !== undefined) known.value = next;
      // An answer counts until the session is there: also while the connection is lost.
      if (next !== undefined || nextId !== idBefore) answer.value = undefined;
    },
    { immediate: true },
  );
  const isMissing = computed(
    () => sessions.list.value !== undefined && isConnected.value && listed.value === undefined,
  );
  watch(
    [() => toValue(id), isMissing],
    ([nextId, missing]) => {
      if (missing && toValue(isNew)) answer.value = 'gone';
      else if (missing) void open(nextId);
    },
    { immediate: true },
  );

  const isGone = computed(() => answer.value === 'gone');
  return {
    session: computed(() =>
      isGone.value && known.value ? sessionAtRest(known.value) : known.value,
    ),
    isGone,
    failure: computed(() => (typeof answer.value === 'object' ? answer.value.failure : undefined)),
    openings: computed(() => openings.value),
  };
}
