import { useMediaQuery } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../../connection/useConnection.ts';
import { useOwnPointer } from './own-pointer.ts';
import { livePointer } from './pointer-topics.ts';
import type { Template } from './templates.ts';

/** Pointer that an example uses. */
export interface ExamplePointer {
  /** Topic of a live pointer, on a phone or in this browser; undefined while there is none. */
  readonly live: ComputedRef<string | undefined>;
  /** Returns the topic for an example: the live one; otherwise starts this browser's pointer. */
  take(template: Template): string;
}

/** Provides a pointer for examples, so that data flows wherever they are started. */
export function useExamplePointer(): ExamplePointer {
  const { client, topics } = useConnection();
  const own = useOwnPointer();
  const isTouch = useMediaQuery('(pointer: coarse)');
  const live = computed(() =>
    livePointer(
      [...(topics.rates.value?.values() ?? [])].map(({ statistic, hz = 0 }) => ({
        topic: statistic.topic,
        format: statistic.dataFormat,
        hz,
      })),
      client.id,
      isTouch.value,
    ),
  );
  return {
    live,
    take(template) {
      if (live.value !== undefined) return live.value;
      if (template.needsPointer) own.isOn.value = true;
      return own.topic.value;
    },
  };
}
