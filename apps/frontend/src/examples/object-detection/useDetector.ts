import { computed, shallowRef, watch, type Ref } from 'vue';
import { useKeptChoice } from '../pictures/useKeptChoice.ts';
import type { useDevice } from '../../devices/useDevice.ts';
import type { SEEING_COMPONENTS } from './seeing-topics.ts';

/** Detectors of the module with their default thresholds; their scores are not comparable. */
export const DETECTORS = [
  { value: 'centernet', text: 'CenterNet', threshold: 0.4 },
  { value: 'coco-ssd', text: 'COCO-SSD', threshold: 0.5 },
] as const;
export type DetectorName = (typeof DETECTORS)[number]['value'];

type SeeingDevice = ReturnType<typeof useDevice<typeof SEEING_COMPONENTS>>;

/** Chosen detector, its threshold, and its problem. */
export function useDetector() {
  const name = shallowRef<DetectorName>('centernet');
  /** Problem that the module reports about detector, backend or pictures; empty when there is none. */
  const problem = shallowRef('');
  const thresholds = useKeptChoice<Record<string, number>>(
    'thresholds',
    Object.fromEntries(DETECTORS.map(({ value, threshold }) => [value, threshold])),
  );
  const threshold = computed({
    get: () => thresholds.value[name.value]!,
    set: (value) => (thresholds.value = { ...thresholds.value, [name.value]: value }),
  });
  return {
    name,
    /** Threshold of this detector; each has its own. */
    threshold,
    problem,
    /** Publishes the choice for the module now, with each change, and after a restart of the master. */
    publishOn(
      device: Pick<SeeingDevice, 'publish' | 'isRegistered'>,
      isConnected: Readonly<Ref<boolean>>,
    ): void {
      watch(
        [name, device.isRegistered, isConnected],
        ([value, isKnown, connected]) => isKnown && connected && device.publish('detector', value),
        { immediate: true },
      );
    },
  };
}
