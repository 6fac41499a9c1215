import { moduleEventTopic, type ModuleEvent } from '@ubii/proto';
import { tryOnScopeDispose } from '@vueuse/core';
import { shallowRef, toValue, watch, type MaybeRefOrGetter, type ShallowRef } from 'vue';
import { perFrame } from '../../connection/per-frame.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { MAX_EVENTS, withEvent } from './event-log.ts';

/** Events of the modules of a session, oldest first, while the calling scope lives. [SE-51] */
export function useSessionEvents(
  sessionId: MaybeRefOrGetter<string>,
): Readonly<ShallowRef<readonly ModuleEvent[]>> {
  const { client } = useConnection();
  const events = shallowRef<readonly ModuleEvent[]>([]);
  let fresh: ModuleEvent[] = [];
  const draw = perFrame(() => {
    events.value = withEvent(events.value, fresh);
    fresh = [];
  });
  const subscribe = (id: string) =>
    client.subscribe(moduleEventTopic(id), { format: 'moduleEvent' }).onRecord(({ value }) => {
      fresh.push(value);
      // A hidden page draws nothing, for as long as it is hidden.
      if (fresh.length > 2 * MAX_EVENTS) fresh = fresh.slice(-MAX_EVENTS);
      draw();
    });
  let subscription: ReturnType<typeof subscribe> | undefined;
  watch(
    () => toValue(sessionId),
    (id) => {
      void subscription?.close();
      fresh = [];
      events.value = [];
      subscription = subscribe(id);
    },
    { immediate: true },
  );
  tryOnScopeDispose(() => void subscription?.close());
  return events;
}
