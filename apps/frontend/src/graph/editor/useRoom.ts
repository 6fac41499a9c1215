import { useLocalStorage, useMediaQuery } from '@vueuse/core';
import { computed, ref, type ComputedRef, type Ref } from 'vue';
import type { GraphEditor } from '../editing/graph-editor.ts';

/** The panels that fit beside the canvas, and those that the user has opened. */
export interface Room {
  /** A phone. */
  readonly isNarrow: Ref<boolean>;
  /** The canvas needs the room: what is selected comes over it when it is asked for. */
  readonly isCompact: Ref<boolean>;
  /** Else the palette is a drawer over the canvas, which lets through what is dragged out of it. */
  readonly isRoomy: Ref<boolean>;
  readonly view: Ref<'graph' | 'list'>;
  readonly isPaletteOpen: Ref<boolean>;
  readonly isInspectorOpen: Ref<boolean>;
  /** Pixels; remembered by this browser. */
  readonly paletteWidth: Ref<number>;
  readonly hasInspector: ComputedRef<boolean>;
  closeInspector(): void;
}

/** @param isEmbedded the editor has only a part of the page */
export function useRoom(editor: GraphEditor, isEmbedded = false): Room {
  const isNarrow = useMediaQuery('(max-width: 759px)');
  const isCompact = isEmbedded ? ref(true) : useMediaQuery('(max-width: 1199px)');
  const isRoomy = isEmbedded ? ref(false) : useMediaQuery('(min-width: 1000px)');
  const view = ref<'graph' | 'list'>(isNarrow.value ? 'list' : 'graph');
  const isPaletteOpen = ref(isRoomy.value);
  const isInspectorOpen = ref(false);
  const hasSelection = computed(
    () => editor.selection.value.nodes.size > 0 || editor.selection.value.wire !== undefined,
  );
  return {
    isNarrow,
    isCompact,
    isRoomy,
    view,
    isPaletteOpen,
    isInspectorOpen,
    paletteWidth: useLocalStorage('ubii.paletteWidth', 240),
    hasInspector: computed(
      () =>
        !isCompact.value ||
        isInspectorOpen.value ||
        (isNarrow.value && view.value === 'list' && hasSelection.value),
    ),
    closeInspector() {
      isInspectorOpen.value = false;
      if (view.value === 'list') editor.select([]);
    },
  };
}
