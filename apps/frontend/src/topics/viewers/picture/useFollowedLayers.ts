import type { TopicRecord } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { ShapeTracker } from '../plane/follow-shapes.ts';
import { pictureLayers, type PictureLayer } from './picture-layers.ts';

/** Layers of records, in which boxes keep their keys, and persons their letters, from record to record. */
export function useFollowedLayers(
  records: () => readonly TopicRecord[],
): ComputedRef<readonly PictureLayer[]> {
  const trackers = new Map<string, ShapeTracker>();
  return computed(() => {
    const layers = pictureLayers(records());
    const nowMs = performance.now();
    for (const topic of trackers.keys()) {
      if (!layers.some((layer) => layer.topic === topic)) trackers.delete(topic);
    }
    return layers.map((layer) => {
      const tracker = trackers.get(layer.topic) ?? new ShapeTracker();
      trackers.set(layer.topic, tracker);
      return { ...layer, shapes: tracker.follow(layer.shapes, nowMs) };
    });
  });
}
