import { ServiceError } from '@ubii/proto';
import {
  computed,
  shallowRef,
  toValue,
  type ComputedRef,
  type MaybeRefOrGetter,
  type ShallowRef,
} from 'vue';
import { usePoll } from '../connection/poll.ts';
import { tryRequest } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';

/** Last reply of a service. */
export interface ServiceAnswer<R> {
  /** `undefined` until the first reply; kept while disconnected. */
  readonly reply: Readonly<ShallowRef<R | undefined>>;
  /** Reason why there is no reply, one sentence; `undefined` without a problem. */
  readonly problem: ComputedRef<string | undefined>;
}

/**
 * Calls a service at an interval while the calling component is mounted and the page is visible.
 *
 * @param enabled false while the reply is not needed
 */
export function useServiceReply<R>(
  ask: () => Promise<R>,
  intervalMs: number,
  enabled: MaybeRefOrGetter<boolean> = true,
): ServiceAnswer<R> {
  const { isConnected } = useConnection();
  const reply = shallowRef<R>();
  const error = shallowRef<ServiceError>();
  usePoll(
    async () => {
      await tryRequest(
        async () => {
          reply.value = await ask();
          error.value = undefined;
        },
        // The connection strip shows a lost connection; polling resumes after reconnecting.
        (cause) => {
          if (cause instanceof ServiceError) error.value = cause;
        },
      );
    },
    intervalMs,
    () => isConnected.value && toValue(enabled),
  );
  return { reply, problem: computed(() => error.value && problemSentence(error.value)) };
}

/** Reason why a master did not reply, in words: an original one does not know the extension services. */
export function problemSentence({ code, message }: ServiceError): string {
  const isUnknown = code === 'unimplemented' || code === 'not_found';
  return isUnknown
    ? 'This master does not provide this. It may be an older version or an original master.'
    : message;
}
