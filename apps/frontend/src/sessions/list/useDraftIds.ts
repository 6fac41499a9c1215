import { useEventListener } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { draftIds } from '../../graph/model/changes/draft.ts';

/** Sessions with changes that somebody made in this browser and has not saved, by their ids. */
export function useDraftIds(): Readonly<ShallowRef<ReadonlySet<string>>> {
  const ids = shallowRef(draftIds(localStorage));
  const look = (): void => {
    ids.value = draftIds(localStorage);
  };
  // Of other tabs, and of the time in which nobody looked.
  useEventListener(window, 'storage', look);
  useEventListener(window, 'focus', look);
  return ids;
}
