import { useEventListener, useLocalStorage, useMediaQuery } from '@vueuse/core';
import { computed, ref, shallowRef, watch, type ComputedRef, type Ref } from 'vue';
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
  /** Stored in this browser where the palette fits beside the canvas. */
  readonly isPaletteOpen: Ref<boolean>;
  readonly isInspectorOpen: Ref<boolean>;
  /** True when something is selected that the inspector can show. */
  readonly hasSelection: ComputedRef<boolean>;
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
  const usual = (): 'graph' | 'list' => (isNarrow.value ? 'list' : 'graph');
  const view = ref(usual());
  // What was chosen holds for windows of this width.
  watch(isNarrow, () => (view.value = usual()));
  const keptPalette = useLocalStorage('ubii.graph.palette', false);
  const isPaletteOpen = ref(isRoomy.value && keptPalette.value);
  watch(isPaletteOpen, (isOpen) => {
    if (isRoomy.value) keptPalette.value = isOpen;
  });
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
    hasSelection,
    paletteWidth: useLocalStorage('ubii.paletteWidth', PALETTE_PX.usual),
    hasInspector: useSettled(() => {
      const isAsked = !isCompact.value || isInspectorOpen.value;
      return hasSelection.value && (isAsked || (isNarrow.value && view.value === 'list'));
    }),
    closeInspector() {
      isInspectorOpen.value = false;
      if (view.value === 'list') editor.select([]);
    },
  };
}

/** Follows a value while no button is pressed: the canvas keeps its width in the middle of a drag. */
function useSettled(value: () => boolean): ComputedRef<boolean> {
  const isPressed = shallowRef(false);
  useEventListener(window, 'pointerdown', () => (isPressed.value = true), { capture: true });
  const release = (): void => void (isPressed.value = false);
  useEventListener(window, ['pointerup', 'pointercancel', 'blur'], release, { capture: true });
  return computed<boolean>((before) =>
    isPressed.value && before !== undefined ? before : value(),
  );
}
