import { moduleEventTopic, type ModuleEvent } from '@ubii/proto';
import { computed, toValue, type ComputedRef, type MaybeRefOrGetter } from 'vue';
import { useTopic } from '../../connection/live/useTopic.ts';
import { MAX_EVENTS } from './event-log.ts';

/** Events of a session's modules, oldest first, while the calling scope is active. [SE-51] */
export function useSessionEvents(
  sessionId: MaybeRefOrGetter<string>,
): ComputedRef<readonly ModuleEvent[]> {
  const { records } = useTopic(() => moduleEventTopic(toValue(sessionId)), {
    format: 'moduleEvent',
    keep: MAX_EVENTS,
    whileHidden: true,
  });
  return computed(() => records.value.map(({ value }) => value));
}
