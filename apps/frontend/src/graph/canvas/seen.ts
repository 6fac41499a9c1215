import {
  computed,
  inject,
  provide,
  ref,
  watch,
  type ComputedRef,
  type InjectionKey,
  type Ref,
} from 'vue';
import { useCanvas } from './useCanvas.ts';
import { overlaps } from './seen-area.ts';

const SEEN: InjectionKey<Ref<boolean>> = Symbol('seen');
const MADE: InjectionKey<Ref<boolean>> = Symbol('made');

/** Whether a node is on the screen or close to it; provided to the views inside it. */
export function provideSeen(id: () => string): ComputedRef<boolean> {
  const { stage } = useCanvas();
  const isSeen = computed(() => {
    const [position, size] = [stage.positions.get(id()), stage.sizes.get(id())];
    // A node that was never rendered has to be, once, to be measured.
    if (position === undefined || size === undefined) return true;
    return overlaps({ ...position, ...size }, stage.area.value);
  });
  provide(SEEN, isSeen);
  return isSeen;
}

/**
 * Whether the contents of a node (rows, sockets, values) are rendered: from the first time it is near the visible area.
 * Graphs open zoomed out, and most nodes never come near.
 */
export function provideMade(isSeen: Readonly<Ref<boolean>>): Readonly<Ref<boolean>> {
  const { stage } = useCanvas();
  const isNear = computed(() => stage.detail.value !== 'far' && isSeen.value);
  const isMade = ref(isNear.value);
  const make = (): void => void (isMade.value = true);
  const stop = watch(isNear, (near) => {
    if (isMade.value) stop();
    // One turn of the wheel may bring many nodes near at once.
    else if (near) stage.soon.add(make);
  });
  provide(MADE, isMade);
  return isMade;
}

export function useMade(): Readonly<Ref<boolean>> {
  return inject(MADE, undefined) ?? ref(true);
}

/** True while the values of a node are readable; otherwise they are not rendered. */
export function useReadable(): ComputedRef<boolean> {
  const { stage } = useCanvas();
  const isSeen = inject(SEEN, undefined);
  return computed(() => stage.detail.value !== 'far' && (isSeen?.value ?? true));
}
