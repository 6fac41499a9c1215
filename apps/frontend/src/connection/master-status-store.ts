import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import type { ServiceError } from '@ubii/proto';
import { shallowRef, type MaybeRefOrGetter, type ShallowRef } from 'vue';
import { mergeMasterStatus, nextSinceMs, type MasterView } from './master-status.ts';
import { usePoll } from './poll.ts';
import { tryRequest, type RequestError } from './useAttempt.ts';

const INTERVAL_MS = 1000;

/** Status of the master, requested once a second while the page is visible. */
export interface MasterStatusStore {
  /** `undefined` until the first reply; kept while disconnected. */
  readonly view: Readonly<ShallowRef<MasterView | undefined>>;
  /** True for an original master, which does not have the service. */
  readonly isUnsupported: Readonly<ShallowRef<boolean>>;
  /** Error of the last request, when the master refused it. */
  readonly error: Readonly<ShallowRef<ServiceError | undefined>>;
}

export function createMasterStatusStore(
  client: UbiiClient,
  isConnected: MaybeRefOrGetter<boolean>,
  nowMs: () => number,
): MasterStatusStore {
  const view = shallowRef<MasterView>();
  const isUnsupported = shallowRef(false);
  const error = shallowRef<ServiceError>();

  function handleError(cause: RequestError): void {
    // Shown by the connection's state; polling resumes after reconnecting.
    if (cause instanceof ConnectionError) return;
    isUnsupported.value = cause.code === 'unimplemented' || cause.code === 'not_found';
    error.value = cause;
  }

  usePoll(
    async () => {
      const sentMs = nowMs();
      const reply = await tryRequest(
        () => client.call('masterStatus', { sinceMs: nextSinceMs(view.value) }),
        handleError,
      );
      if (reply === undefined) return;
      view.value = mergeMasterStatus(view.value, reply, sentMs, nowMs());
      isUnsupported.value = false;
      error.value = undefined;
    },
    INTERVAL_MS,
    isConnected,
  );

  return { view, isUnsupported, error };
}
