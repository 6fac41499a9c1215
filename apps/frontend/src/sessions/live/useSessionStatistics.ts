import { sessionStatisticsTopic, type SessionStatistics } from '@ubii/proto';
import { tryOnScopeDispose, useDocumentVisibility } from '@vueuse/core';
import { shallowRef, watch, type ShallowRef } from 'vue';
import { perFrame } from '../../connection/per-frame.ts';
import { useConnection } from '../../connection/useConnection.ts';

/** The newest statistics by the id of their session, drawn once a frame. */
export type StatisticsById = ReadonlyMap<string, SessionStatistics>;

/**
 * How sessions do, while the calling scope lives. [SE-50]
 * @param sessionId one session; without it all of them
 */
export function useSessionStatistics(sessionId = '*'): Readonly<ShallowRef<StatisticsById>> {
  const { client, isConnected } = useConnection();
  const newest = new Map<string, SessionStatistics>();
  const shown = shallowRef<StatisticsById>(new Map());
  const draw = perFrame(() => (shown.value = new Map(newest)));
  const subscribe = () =>
    client
      .subscribe({ glob: sessionStatisticsTopic(sessionId) }, { format: 'sessionStatistics' })
      .onRecord(({ value }) => {
        newest.set(value.sessionId, value);
        draw();
      });
  // Statistics of many modules are long: do not subscribe while the page is hidden.
  const visibility = useDocumentVisibility();
  let subscription: ReturnType<typeof subscribe> | undefined;
  const end = (): void => {
    void subscription?.close();
    subscription = undefined;
  };
  watch(
    visibility,
    (now) => {
      end();
      if (now === 'visible') subscription = subscribe();
    },
    { immediate: true },
  );
  // While the master is away, nothing is known of now.
  watch(isConnected, (connected) => {
    if (connected) return;
    newest.clear();
    draw();
  });
  tryOnScopeDispose(end);
  return shown;
}
