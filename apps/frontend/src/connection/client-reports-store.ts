import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import type { ClientActivity, ServiceError } from '@ubii/proto';
import { computed, shallowRef, type Ref, type ShallowRef } from 'vue';
import { createInterest } from './interest.ts';
import { usePoll } from './poll.ts';
import { tryRequest, type RequestError } from './useAttempt.ts';

/** Traffic and load of each client; requested only while there are viewers. [EX-25] */
export interface ClientReportsStore {
  /** By client id; `undefined` until the first reply, kept while disconnected. */
  readonly byId: Readonly<ShallowRef<ReadonlyMap<string, ClientActivity> | undefined>>;
  /** Time of the newest reply, epoch milliseconds of the master's clock; 0 before. */
  readonly masterTimeMs: Readonly<ShallowRef<number>>;
  /** True when the master does not have the service. */
  readonly isUnsupported: Readonly<ShallowRef<boolean>>;
  /** Error of the last request, when the master refused it. */
  readonly error: Readonly<ShallowRef<ServiceError | undefined>>;
  /** Requests reports at this interval while the calling component or scope is active, milliseconds. */
  watch(intervalMs: number): void;
  /** Requests at once, after a change. */
  refresh(): Promise<void>;
}

export function createClientReportsStore(
  client: UbiiClient,
  isConnected: Ref<boolean>,
): ClientReportsStore {
  const byId = shallowRef<ReadonlyMap<string, ClientActivity>>();
  const masterTimeMs = shallowRef(0);
  const isUnsupported = shallowRef(false);
  const error = shallowRef<ServiceError>();
  const interest = createInterest();

  async function refresh(): Promise<void> {
    const report = await tryRequest(() => client.call('clientReport', {}), handleError);
    if (report === undefined) return;
    byId.value = new Map(report.clients.map((activity) => [activity.clientId, activity]));
    masterTimeMs.value = report.masterTimeMs;
    isUnsupported.value = false;
    error.value = undefined;
  }
  function handleError(cause: RequestError): void {
    // Shown by the connection's state; polling resumes after reconnecting.
    if (cause instanceof ConnectionError) return;
    isUnsupported.value = cause.code === 'unimplemented' || cause.code === 'not_found';
    error.value = cause;
  }

  usePoll(
    refresh,
    () => interest.intervalMs.value ?? 0,
    computed(() => isConnected.value && interest.intervalMs.value !== undefined),
  );

  return {
    byId,
    masterTimeMs,
    isUnsupported,
    error,
    watch: (intervalMs) => interest.express(intervalMs),
    refresh,
  };
}
