import { ConnectionError } from '@ubii/client-web';
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
import { useConnection } from '../connection/useConnection.ts';

/** What a service of the master last answered. */
export interface ServiceAnswer<R> {
  /** `undefined` until the first answer; kept while disconnected. */
  readonly reply: Readonly<ShallowRef<R | undefined>>;
  /** Why there is none, one sentence; `undefined` while all is well. */
  readonly problem: ComputedRef<string | undefined>;
}

/**
 * Asks a service again and again while the calling component lives and the page is seen.
 *
 * @param enabled false while there is no use in asking
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
      try {
        reply.value = await ask();
        error.value = undefined;
      } catch (cause) {
        // A failed link shows in the strip under the top bar, and the poll goes on after it
        if (cause instanceof ConnectionError) return;
        if (!(cause instanceof ServiceError)) throw cause;
        error.value = cause;
      }
    },
    intervalMs,
    () => isConnected.value && toValue(enabled),
  );
  return { reply, problem: computed(() => error.value && problemSentence(error.value)) };
}

/** Why a master did not answer, in words: an original one does not know our services. */
export function problemSentence({ code, message }: ServiceError): string {
  const isUnknown = code === 'unimplemented' || code === 'not_found';
  return isUnknown
    ? 'This master does not provide this. It may be an older version or an original master.'
    : message;
}
