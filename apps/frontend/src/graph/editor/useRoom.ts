import { useLocalStorage, useMediaQuery } from '@vueuse/core';
import { computed, ref, type ComputedRef, type Ref } from 'vue';
import type { GraphEditor } from '../editing/graph-editor.ts';

/** Limits of the width of the palette, pixels. */
export const PALETTE_PX = { min: 200, max: 480, usual: 240 };

/** Layout of the panels beside the canvas, and those that the user opened. */
export interface Room {
  /** True on phones. */
  readonly isNarrow: Ref<boolean>;
  /** True when the inspector has no room beside the canvas and is shown over it on request. */
  readonly isCompact: Ref<boolean>;
  /**
   * True when the palette fits beside the canvas; otherwise it is a drawer over it, which does not block dragging items
   * out.
   */
  readonly isRoomy: Ref<boolean>;
  readonly view: Ref<'graph' | 'list'>;
  readonly isPaletteOpen: Ref<boolean>;
  readonly isInspectorOpen: Ref<boolean>;
  /** Pixels; stored in this browser. */
  readonly paletteWidth: Ref<number>;
  readonly hasInspector: ComputedRef<boolean>;
  closeInspector(): void;
}

/** @param isEmbedded the editor is part of another page */
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
    paletteWidth: useLocalStorage('ubii.paletteWidth', PALETTE_PX.usual),
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
