import { usePreferredReducedMotion, useRafFn } from '@vueuse/core';
import { shallowRef, watch, type ShallowRef } from 'vue';
import { ShapeEasing } from '../plane/ease-shapes.ts';
import type { PictureLayer } from './picture-layers.ts';

/** Animates layers to their new positions. Without easing, or with reduced motion, they move at once. */
export function useEasedLayers(
  layers: () => readonly PictureLayer[],
  isEased: () => boolean,
): Readonly<ShallowRef<readonly PictureLayer[]>> {
  const motion = usePreferredReducedMotion();
  const shown = shallowRef<readonly PictureLayer[]>([]);
  const moving = new Map<string, { layer: PictureLayer; readonly easing: ShapeEasing }>();

  function draw(): void {
    const nowMs = performance.now();
    let isMoving = false;
    shown.value = [...moving].flatMap(([topic, { layer, easing }]) => {
      const now = easing.at(nowMs);
      isMoving ||= now.isMoving;
      if (now.shapes.length === 0 && layer.shapes.length === 0) moving.delete(topic);
      return { ...layer, shapes: now.shapes };
    });
    if (!isMoving) frames.pause();
  }
  const frames = useRafFn(draw, { immediate: false });

  watch(
    [layers, isEased, motion],
    ([next, eased, preference]) => {
      if (!eased || preference === 'reduce') {
        moving.clear();
        frames.pause();
        shown.value = next;
        return;
      }
      const nowMs = performance.now();
      const byTopic = new Map(next.map((layer) => [layer.topic, layer]));
      for (const [topic, one] of moving) {
        if (byTopic.has(topic)) continue;
        one.layer = { ...one.layer, shapes: [] };
        one.easing.set([], nowMs);
      }
      for (const [topic, layer] of byTopic) {
        const easing = moving.get(topic)?.easing ?? new ShapeEasing();
        easing.set(layer.shapes, nowMs);
        moving.set(topic, { layer, easing });
      }
      frames.resume();
    },
    { immediate: true },
  );
  return shown;
}
