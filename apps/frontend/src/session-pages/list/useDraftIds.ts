import { useEventListener } from '@vueuse/core';
import { shallowRef, type ShallowRef } from 'vue';
import { draftIds, removeDraft } from '../../graph/model/changes/draft.ts';

/** Sessions with unsaved changes in this browser, by their ids. */
export interface DraftIds {
  readonly ids: Readonly<ShallowRef<ReadonlySet<string>>>;
  discard(id: string): void;
}

export function useDraftIds(): DraftIds {
  const ids = shallowRef(draftIds(localStorage));
  const look = (): void => {
    ids.value = draftIds(localStorage);
  };
  // Other tabs may have changed them, also while this one was in the background.
  useEventListener(window, 'storage', look);
  useEventListener(window, 'focus', look);
  return {
    ids,
    discard(id) {
      removeDraft(localStorage, id);
      look();
    },
  };
}
