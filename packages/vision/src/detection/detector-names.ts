/** Detectors by the names that modules use; the first one is the default and replaces others. */
export const DETECTOR_NAMES = ['centernet', 'coco-ssd'] as const;

export type DetectorName = (typeof DETECTOR_NAMES)[number];
