import { computed, ref, type ComputedRef, type Ref } from 'vue';
import { useFavouriteModules } from '../../../modules/library/favourite-modules.ts';
import { useRecentModules } from '../../../modules/library/recent-modules.ts';
import { useGraphContext } from '../../live/useGraphContext.ts';
import { portOf } from '../../model/port-format.ts';
import type { PortRef } from '../../model/graph.ts';
import { firstShown, moduleOf, type Addable, type AddableSources } from '../addable.ts';
import { useCanvas } from '../useCanvas.ts';
import { categoriesOf, type Category } from './categories.ts';
import { paletteEntries, wantedFormat, type PaletteWish } from './palette-entries.ts';

/** What the palette was opened for. */
export interface PaletteTask {
  readonly sources: AddableSources;
  /** Port at the fixed end of the dangling wire. */
  readonly end: PortRef | undefined;
  /** Id of the wire that the new node is inserted into. */
  readonly wire: string | undefined;
  /** Existing sockets that fit the wire are listed first. */
  readonly hasSockets: boolean;
}

export interface PaletteList {
  readonly text: Ref<string>;
  /** Key of the chosen category. */
  readonly category: Ref<string>;
  readonly categories: ComputedRef<readonly Category[]>;
  /** Only what fits the wire. */
  readonly isFiltered: Ref<boolean>;
  /** Short name of the format that entries must fit; empty: unknown. */
  readonly format: ComputedRef<string>;
  readonly found: ComputedRef<readonly Addable[]>;
  /** `7 of 96`; empty without a search. */
  readonly counted: ComputedRef<string>;
  /** Keeps that it was used, so that it comes first. */
  note(one: Addable): void;
  isFavourite(one: Addable): boolean;
  /** Marks a module as favourite, or no longer. */
  mark(one: Addable): void;
}

/** Search, categories and filter of the palette. */
export function usePaletteList({ sources, end, wire, hasSockets }: PaletteTask): PaletteList {
  const { editor } = useGraphContext();
  const { stage } = useCanvas();
  const used = useRecentModules();
  // As they were when it opened: rows must not move below the pointer while topics come and go.
  const recent = [...used.names.value];
  const marked = useFavouriteModules();
  const favourites = [...marked.names.value];
  const { topics, used: taken, nameTopic } = sources;
  const here: AddableSources = {
    topics,
    ...(taken && { used: taken }),
    ...(nameTopic && { nameTopic }),
    get modules() {
      return sources.modules;
    },
  };
  const text = ref('');
  const category = ref('all');
  const isFiltered = ref(end !== undefined || wire !== undefined);
  const wish = computed((): PaletteWish => {
    const graph = editor.graph.value;
    const placeOf = (at: PortRef) => stage.socketAt(at, portOf(graph, at)?.direction ?? 'in');
    const isOfSockets = end !== undefined && hasSockets;
    return {
      end,
      wire,
      favourites,
      recent,
      isFiltered: isFiltered.value,
      placeOf: isOfSockets ? placeOf : undefined,
    };
  });
  const all = computed(() => paletteEntries(editor.graph.value, here, '', wish.value));
  const categories = computed(() =>
    categoriesOf(all.value, { favourites: marked.names.value, recent }),
  );
  const matching = computed(() => {
    const isAsked = text.value.trim() !== '';
    return isAsked ? paletteEntries(editor.graph.value, here, text.value, wish.value) : all.value;
  });
  const chosen = computed(() => categories.value.find(({ key }) => key === category.value));
  return {
    text,
    category,
    categories,
    isFiltered,
    format: computed(() => wantedFormat(editor.graph.value, wish.value)),
    found: computed(() =>
      firstShown(matching.value.filter((one) => chosen.value?.has(one) ?? true)),
    ),
    counted: computed(() => {
      if (text.value.trim() === '') return '';
      const known = new Set(all.value.map(({ key }) => key));
      const count = matching.value.filter(({ key }) => known.has(key)).length;
      return `${count} of ${all.value.length}`;
    }),
    note(one) {
      const module = moduleOf(one);
      if (module !== undefined) used.note(module.name);
    },
    isFavourite: (one) => marked.names.value.includes(moduleOf(one)?.name ?? ''),
    mark(one) {
      const module = moduleOf(one);
      if (module !== undefined) marked.toggle(module.name);
    },
  };
}
