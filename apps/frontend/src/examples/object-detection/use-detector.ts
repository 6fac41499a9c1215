import { shallowRef, watch, type Ref } from 'vue';
import type { useDevice } from '../../devices/use-device.ts';
import type { SEEING_COMPONENTS } from './seeing-topics.ts';

/** Detectors of the module, with the threshold that each has by itself: their scores differ. */
export const DETECTORS = [
  { value: 'centernet', text: 'CenterNet', threshold: 0.4 },
  { value: 'coco-ssd', text: 'COCO-SSD', threshold: 0.5 },
] as const;
export type DetectorName = (typeof DETECTORS)[number]['value'];

type SeeingDevice = ReturnType<typeof useDevice<typeof SEEING_COMPONENTS>>;

/** Which detector looks at the pictures, and what is wrong with it. */
export function useDetector(threshold: Ref<number>) {
  const name = shallowRef<DetectorName>('centernet');
  /** What the module says of detector, backend and pictures; empty when all is well. */
  const problem = shallowRef('');
  watch(name, (value) => {
    threshold.value = DETECTORS.find((one) => one.value === value)!.threshold;
  });
  return {
    name,
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
