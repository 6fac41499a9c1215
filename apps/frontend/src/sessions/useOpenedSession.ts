import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Session } from '@ubii/proto';
import { computed, shallowRef, toValue, watch, type ComputedRef, type MaybeRefOrGetter } from 'vue';
import { tryRequest, type RequestError } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';
import { useSessionActions } from './actions/useSessionActions.ts';
import { sessionAtRest } from './state/session-state.ts';

/** The session of a URL. */
export interface OpenedSession {
  /** State on the master, or the last known one. */
  readonly session: ComputedRef<Session | undefined>;
  /** True when the master has no session with this id, neither open nor stored. */
  readonly isGone: ComputedRef<boolean>;
  /** Reason why a stored session cannot be opened. */
  readonly failure: ComputedRef<string | undefined>;
  /** Number of times it was opened here: after a restart of the master its revisions may be lower. */
  readonly openings: ComputedRef<number>;
}

/**
 * Observes the session with an id, and opens it on the master when it is only stored. [SE-27]
 * @param isNew the id was created here and is unknown to the master
 */
export function useOpenedSession(
  id: MaybeRefOrGetter<string>,
  isNew: MaybeRefOrGetter<boolean> = false,
): OpenedSession {
  const { client, sessions, isConnected } = useConnection();
  const { calls } = useSessionActions();
  const listed = computed(() => sessions.list.value?.find((one) => one.id === toValue(id)));
  const known = shallowRef<Session>();
  /** Reply of the master to the request for an unlisted session. */
  const answer = shallowRef<'gone' | { readonly failure: string }>();
  const openings = shallowRef(0);

  /** Read-only users get the stored session without opening it. */
  async function readStored(sessionId: string): Promise<Session> {
    return client.call('sessionRuntimeGet', { id: sessionId });
  }

  async function open(sessionId: string): Promise<void> {
    await tryRequest(async () => {
      const opened = await calls.open(sessionId).catch((cause: unknown) => {
        const isViewer = cause instanceof ServiceError && cause.code === 'permission_denied';
        if (!isViewer) throw cause;
        return readStored(sessionId);
      });
      if (sessionId !== toValue(id)) return;
      known.value = opened;
      openings.value += 1;
    }, refuse);

    function refuse(cause: RequestError): void {
      // Requested again after a reconnect.
      if (cause instanceof ConnectionError || sessionId !== toValue(id)) return;
      answer.value = cause.code === 'not_found' ? 'gone' : { failure: cause.message };
    }
  }

  watch(
    [() => toValue(id), listed],
    ([nextId, next], [idBefore]) => {
      if (known.value?.id !== nextId) known.value = undefined;
      if (next !== undefined) known.value = next;
      // The reply is valid until the session exists, also while disconnected.
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
