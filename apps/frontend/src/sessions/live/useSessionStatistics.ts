import { sessionStatisticsTopic, type SessionStatistics } from '@ubii/proto';
import { tryOnScopeDispose } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { perFrame } from '../../connection/per-frame.ts';
import { useConnection } from '../../connection/useConnection.ts';

/** The newest statistics by the id of their session, drawn once a frame. */
export type StatisticsById = ReadonlyMap<string, SessionStatistics>;

/**
 * How sessions do, while the calling scope lives. [SE-50]
 * @param sessionId one session; without it all of them
 */
export function useSessionStatistics(sessionId = '*'): Readonly<ShallowRef<StatisticsById>> {
  const { client } = useConnection();
  const newest = new Map<string, SessionStatistics>();
  const shown = shallowRef<StatisticsById>(new Map());
  const draw = perFrame(() => (shown.value = new Map(newest)));
  const subscription = client
    .subscribe({ glob: sessionStatisticsTopic(sessionId) }, { format: 'sessionStatistics' })
    .onRecord(({ value }) => {
      newest.set(value.sessionId, value);
      draw();
    });
  tryOnScopeDispose(() => void subscription.close());
  return shown;
}
