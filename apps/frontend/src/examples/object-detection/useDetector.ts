import { computed, shallowRef, watch, type Ref } from 'vue';
import { useKeptChoice } from '../pictures/useKeptChoice.ts';
import type { useDevice } from '../../devices/useDevice.ts';
import type { SEEING_COMPONENTS } from './seeing-topics.ts';

/** Detectors of the module, with the threshold that each has by itself: their scores differ. */
export const DETECTORS = [
  { value: 'centernet', text: 'CenterNet', threshold: 0.4 },
  { value: 'coco-ssd', text: 'COCO-SSD', threshold: 0.5 },
] as const;
export type DetectorName = (typeof DETECTORS)[number]['value'];

type SeeingDevice = ReturnType<typeof useDevice<typeof SEEING_COMPONENTS>>;

/** Which detector looks at the pictures, with which threshold, and what is wrong with it. */
export function useDetector() {
  const name = shallowRef<DetectorName>('centernet');
  /** What the module says of detector, backend and pictures; empty when all is well. */
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
    /** Of this detector; each keeps its own. */
    threshold,
    problem,
    /** Tells the module, now, with each change, and again after a restart of the master. */
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
