import { computed, inject, provide, type ComputedRef, type InjectionKey, type Ref } from 'vue';
import { useCanvas } from '../editor/use-graph-editor.ts';
import { overlaps } from './seen-area.ts';

const SEEN: InjectionKey<Ref<boolean>> = Symbol('seen');

/** Whether a node is on the screen or close to it, for what is in it, too. */
export function provideSeen(id: () => string): ComputedRef<boolean> {
  const { stage } = useCanvas();
  const isSeen = computed(() => {
    const [position, size] = [stage.positions.get(id()), stage.sizes.get(id())];
    // What was never drawn has to be, once, to be measured.
    if (position === undefined || size === undefined) return true;
    return overlaps({ ...position, ...size }, stage.area.value);
  });
  provide(SEEN, isSeen);
  return isSeen;
}

/** True while the values of a node can be read: what nobody sees is not drawn. */
export function useReadable(): ComputedRef<boolean> {
  const { stage } = useCanvas();
  const isSeen = inject(SEEN, undefined);
  return computed(() => stage.detail.value !== 'far' && (isSeen?.value ?? true));
}
