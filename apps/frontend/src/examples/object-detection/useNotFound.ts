import { computed, type ComputedRef } from 'vue';
import { SEEING_MODULES, type Seen } from '../../devices/camera/seeing-session.ts';
import type { PictureSources } from '../pictures/usePictureSource.ts';
import { useFoundNothing } from '../pictures/useFoundNothing.ts';
import type { Found } from './useObjectDetection.ts';

/** What the modules look for and have not found. */
export interface NotFound {
  readonly wanted: readonly Seen[];
  readonly sentence: string;
}

/** What the modules look for, when none of them has found anything for some seconds; else undefined. */
export function useNotFound(
  sources: PictureSources,
  {
    found,
    looksFor,
  }: {
    readonly found: Readonly<{ value: Found }>;
    readonly looksFor: Readonly<Record<Seen, boolean>>;
  },
): ComputedRef<NotFound | undefined> {
  const kinds = (Object.keys(SEEING_MODULES) as Seen[]).map((kind) => ({
    kind,
    foundNothing: useFoundNothing(
      sources,
      () => found.value.get(kind),
      () => looksFor[kind],
    ),
  }));
  return computed(() => {
    const on = kinds.filter(({ kind }) => looksFor[kind]);
    // A module that finds something shows that the source is a good one.
    if (on.length === 0 || !on.every(({ foundNothing }) => foundNothing.value)) return undefined;
    const wanted = on.map(({ kind }) => kind);
    return { wanted, sentence: `No ${wanted.join(' and no ')} were found in the last seconds.` };
  });
}
