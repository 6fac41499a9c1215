import type { TopicRecord } from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import { EmptyResults } from './empty-results.ts';
import type { PictureSources } from './usePictureSource.ts';

/** Returns the elements of a list of objects; undefined for other formats. */
function elementsOf(record: TopicRecord): readonly unknown[] | undefined {
  const isList = record.format === 'object2DList' || record.format === 'object3DList';
  return isList ? record.value.elements : undefined;
}

/**
 * True after a module has found nothing in the source for some seconds.
 *
 * @param result the newest list of objects
 * @param module a change restarts the measurement
 */
export function useFoundNothing(
  { kind, clip, topic }: Pick<PictureSources, 'kind' | 'clip' | 'topic'>,
  result: () => TopicRecord | undefined,
  module: () => unknown,
): Readonly<ShallowRef<boolean>> {
  const results = new EmptyResults();
  const isLong = shallowRef(false);
  watch(result, (record) => {
    if (record === undefined) results.clear();
    const elements = record && elementsOf(record);
    if (elements) results.note(elements.length === 0, record.timestampMs ?? performance.now());
    isLong.value = results.isLong;
  });
  watch([kind, clip, topic, module], () => {
    results.clear();
    isLong.value = false;
  });
  return isLong;
}
