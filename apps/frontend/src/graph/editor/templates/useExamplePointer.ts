import { useMediaQuery } from '@vueuse/core';
import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../../connection/useConnection.ts';
import { useOwnPointer } from './own-pointer.ts';
import { livePointer } from './pointer-topics.ts';
import type { Template } from './templates.ts';

/** The pointer that an example takes. */
export interface ExamplePointer {
  /** Its topic, on a phone or here; undefined while none is live. */
  readonly live: ComputedRef<string | undefined>;
  /** The topic an example takes: the live one, else this browser's, which begins. */
  take(template: Template): string;
}

/** Wherever examples are started, something flows through them. */
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
