import { computed, type ComputedRef } from 'vue';
import { isGone, nameMasters, type NamedMaster } from './masters.ts';
import { useConnection } from './useConnection.ts';

/** Name for masters that were lost before this page could learn theirs. */
const UNKNOWN = 'a lost master';

/** The masters of the cluster. Pages name masters only where there are several. */
export interface Masters {
  /** Own master first; empty at a master that is alone. */
  readonly list: ComputedRef<readonly NamedMaster[]>;
  readonly areSeveral: ComputedRef<boolean>;
  /** Name of a master; empty without an id, and unless there are several masters. */
  labelOf(id: string | undefined): string;
  /** The same, and empty for ids that are of no known master. */
  labelOfKnown(id: string): string;
  /** True for a master that is not there any more. */
  isGone(id: string): boolean;
}

export function useMasters(): Masters {
  const { master } = useConnection();
  const list = computed(() => nameMasters(master.view.value?.latest.cluster?.masters ?? []));
  const byId = computed(() => new Map(list.value.map((named) => [named.master.id, named])));
  const areSeveral = computed(() => list.value.length > 1);
  return {
    list,
    areSeveral,
    labelOf(id) {
      if (!areSeveral.value || id === undefined || id === '') return '';
      return byId.value.get(id)?.label ?? UNKNOWN;
    },
    labelOfKnown: (id) => (areSeveral.value ? (byId.value.get(id)?.label ?? '') : ''),
    isGone(id) {
      const named = byId.value.get(id);
      return areSeveral.value && (named === undefined || isGone(named.master));
    },
  };
}
