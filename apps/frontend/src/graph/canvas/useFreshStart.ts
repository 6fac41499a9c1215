import { useTimeoutFn } from '@vueuse/core';
import { computed, ref, watch, type ComputedRef } from 'vue';
import { isAlive } from '../../sessions/state/session-state.ts';
import type { GraphEditor } from '../editing/graph-editor.ts';

/** Time after a start during which the wires of a small graph show values, milliseconds. */
const FRESH_MS = 10_000;
/** Most wires of a small graph; in larger graphs values would hide the wires. */
const MAX_WIRES = 12;

/** True for some time after a start, so that the user sees whether values arrive. */
export function useFreshStart(editor: GraphEditor): ComputedRef<boolean> {
  const isOn = ref(false);
  const { start } = useTimeoutFn(() => (isOn.value = false), FRESH_MS, { immediate: false });
  watch(
    () => isAlive(editor.session.value),
    (alive, before) => {
      isOn.value = alive && !before;
      if (isOn.value) start();
    },
  );
  return computed(() => isOn.value && editor.graph.value.wires.size <= MAX_WIRES);
}
