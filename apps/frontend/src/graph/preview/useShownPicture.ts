import type { Image2D, TopicRecord } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { useGraphContext } from '../live/useGraphContext.ts';
import { imageOf } from './image-of.ts';
import { foundIn, pictureOf } from './picture-links.ts';

/** A picture and the objects detected in it; no picture when it is unknown. */
export interface ShownPicture {
  readonly image: Image2D | undefined;
  readonly found: readonly TopicRecord[];
}

/**
 * Returns the picture that a topic shows on the canvas: its own with objects that modules of the session detect in it,
 * or the one that its objects were detected in; `undefined` for other values.
 *
 * @param isReadable false: the result stays unchanged
 */
export function useShownPicture(
  topic: () => string | undefined,
  record: () => TopicRecord | undefined,
  isReadable: () => boolean = () => true,
): ComputedRef<ShownPicture | undefined> {
  const { editor, live } = useGraphContext();
  return computed((before) => {
    const [name, newest] = [topic(), record()];
    if (name === undefined || newest === undefined) return undefined;
    const isList = newest.format === 'object2DList';
    if (!isList && imageOf(newest) === undefined) return undefined;
    if (!isReadable()) return before;
    const { value: graph } = editor.graph;
    const recordOf = (other: string | undefined): TopicRecord | undefined =>
      other === undefined ? undefined : live.topic(other)?.record;
    if (isList) return { image: imageOf(recordOf(pictureOf(graph, name))), found: [newest] };
    return {
      image: imageOf(newest),
      found: foundIn(graph, name).flatMap((other) => recordOf(other) ?? []),
    };
  });
}
