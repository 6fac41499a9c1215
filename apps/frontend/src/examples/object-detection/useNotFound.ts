import { computed, type ComputedRef } from 'vue';
import { SEEING_MODULES, type Seen } from '../../devices/camera/seeing-session.ts';
import type { PictureSources } from '../pictures/usePictureSource.ts';
import { useFoundNothing } from '../pictures/useFoundNothing.ts';
import type { Found } from './useObjectDetection.ts';

/** A sentence that names what the modules have not found for some seconds; undefined if they find everything. */
export function useNotFound(
  sources: PictureSources,
  {
    found,
    looksFor,
  }: {
    readonly found: Readonly<{ value: Found }>;
    readonly looksFor: Readonly<Record<Seen, boolean>>;
  },
): ComputedRef<string | undefined> {
  const kinds = (Object.keys(SEEING_MODULES) as Seen[]).map((kind) => ({
    kind,
    foundNothing: useFoundNothing(
      sources,
      () => found.value.get(kind),
      () => looksFor[kind],
    ),
  }));
  return computed(() => {
    const missing = kinds.filter(({ foundNothing }) => foundNothing.value);
    if (missing.length === 0) return undefined;
    const words = missing.map(({ kind }) => kind).join(' and no ');
    return `No ${words} were found in the last seconds.`;
  });
}
