import type { TopicRecord } from '@ubii/proto';
import { useIntervalFn } from '@vueuse/core';
import { computed, reactive, shallowRef, watch } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { Seen } from '../../devices/camera/seeing-session.ts';
import type { PictureLayer } from '../../topics/viewers/picture/picture-layers.ts';
import { useFollowedLayers } from '../../topics/viewers/picture/useFollowedLayers.ts';
import { planeShapes } from '../../topics/viewers/plane/plane-shapes.ts';
import { ScoreHistogram } from './score-histogram.ts';
import { seenThings } from './seen-things.ts';

/** Interval between updates of the histogram, milliseconds. */
const HISTOGRAM_MS = 250;

/** Display of the results: marks, list, and histogram of the last ten seconds. */
export function useSeeingView(detection: {
  readonly found: Readonly<{ value: ReadonlyMap<Seen, TopicRecord> }>;
  readonly belowThreshold: Readonly<{ value: TopicRecord | undefined }>;
  readonly threshold: Readonly<{ value: number }>;
  readonly isOn: Readonly<{ value: boolean }>;
  /** True for sources that change without the master. */
  readonly isMoving: Readonly<{ value: boolean }>;
}) {
  const { isConnected } = useConnection();
  const shown = reactive({ boxes: true, skeletons: true });
  const { found, belowThreshold, threshold, isOn, isMoving } = detection;

  const followed = useFollowedLayers(() => [...found.value.values()]);
  const objects = computed(() => {
    const topic = found.value.get('objects')?.topic;
    return followed.value.find((layer) => layer.topic === topic)?.shapes ?? [];
  });
  /** A higher threshold applies at once, a lower one from the next picture. */
  const isAbove = ({ score = 1 }: { readonly score?: number }): boolean => score >= threshold.value;
  /** Hide results from before a disconnect: they belong to an older picture. */
  const fitting = computed(() => (isConnected.value || !isMoving.value ? followed.value : []));
  const layers = computed((): PictureLayer[] =>
    fitting.value.map((layer) => ({
      ...layer,
      shapes: layer.shapes.filter((shape) =>
        shape.size ? shown.boxes && isAbove(shape) : shown.skeletons,
      ),
    })),
  );
  const below = computed(() => {
    const record = isOn.value ? belowThreshold.value : undefined;
    return (record && planeShapes(record)?.shapes) ?? [];
  });
  const things = computed(() => {
    const all = [...objects.value, ...below.value];
    return seenThings(
      objects.value.filter(isAbove),
      all.filter((shape) => !isAbove(shape)),
    );
  });

  const histogram = new ScoreHistogram();
  const heights = shallowRef<readonly number[]>(histogram.heights(0));
  watch(
    () => found.value.get('objects'),
    (record) => record && histogram.add(objects.value.map(scoreOf), performance.now()),
  );
  watch(belowThreshold, (record) => {
    if (record) histogram.add(below.value.map(scoreOf), performance.now());
  });
  watch(isOn, () => histogram.clear());
  useIntervalFn(() => {
    if (isConnected.value) heights.value = histogram.heights(performance.now());
  }, HISTOGRAM_MS);

  return { shown, layers, things, heights };
}

const scoreOf = ({ score = 0 }: { readonly score?: number }): number => score;
