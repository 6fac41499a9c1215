import { moduleEventTopic, type ModuleEvent } from '@ubii/proto';
import { tryOnScopeDispose } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { perFrame } from '../../connection/per-frame.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { MAX_EVENTS, withEvent } from './event-log.ts';

/** What the modules of a session have to say, oldest first, while the calling scope lives. [SE-51] */
export function useSessionEvents(sessionId: string): Readonly<ShallowRef<readonly ModuleEvent[]>> {
  const { client } = useConnection();
  const events = shallowRef<readonly ModuleEvent[]>([]);
  let fresh: ModuleEvent[] = [];
  const draw = perFrame(() => {
    events.value = withEvent(events.value, fresh);
    fresh = [];
  });
  const subscription = client
    .subscribe(moduleEventTopic(sessionId), { format: 'moduleEvent' })
    .onRecord(({ value }) => {
      fresh.push(value);
      // A hidden page draws nothing, for as long as it is hidden.
      if (fresh.length > 2 * MAX_EVENTS) fresh = fresh.slice(-MAX_EVENTS);
      draw();
    });
  tryOnScopeDispose(() => void subscription.close());
  return events;
}
