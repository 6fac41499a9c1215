import type { TopicRecord } from '@ubii/proto';
import { useRafFn } from '@vueuse/core';
import { onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';
import { useConnection } from '../../../connection/useConnection.ts';

/** Maximum visible rate, records per second. */
const RATE_HZ = 30;

/** The newest records of the topics that are drawn over a picture. */
export function useOverlays(
  topics: () => readonly string[],
): Readonly<ShallowRef<ReadonlyMap<string, TopicRecord>>> {
  const { client } = useConnection();
  const shown = shallowRef<ReadonlyMap<string, TopicRecord>>(new Map());
  const newest = new Map<string, TopicRecord>();
  const close = new Map<string, () => void>();
  let hasChanged = false;

  watch(
    () => [...topics()],
    (names) => {
      for (const [name, end] of close) {
        if (names.includes(name)) continue;
        end();
        close.delete(name);
        newest.delete(name);
        hasChanged = true;
      }
      for (const name of names) {
        if (close.has(name)) continue;
        const subscription = client.subscribe(name, { maxRateHz: RATE_HZ }).onRecord((record) => {
          newest.set(name, record);
          hasChanged = true;
        });
        // Refused by the master: there is nothing to draw then.
        subscription.ready.catch(() => undefined);
        close.set(name, () => void subscription.close());
      }
    },
    { immediate: true },
  );
  useRafFn(() => {
    if (!hasChanged) return;
    hasChanged = false;
    shown.value = new Map(newest);
  });
  onScopeDispose(() => {
    for (const end of close.values()) end();
  });
  return shown;
}
