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

/**
 * Whether what is in a node is made: its rows, sockets and values are, once it has been near. Graphs are
 * opened from afar, and most of their nodes never come near.
 */
export function provideMade(isSeen: Readonly<Ref<boolean>>): Readonly<Ref<boolean>> {
  const { stage } = useCanvas();
  const isNear = computed(() => stage.detail.value !== 'far' && isSeen.value);
  const isMade = ref(isNear.value);
  const make = (): void => void (isMade.value = true);
  const stop = watch(isNear, (near) => {
    if (isMade.value) stop();
    // Many may come near at once, by one turn of a wheel.
    else if (near) stage.soon.add(make);
  });
  provide(MADE, isMade);
  return isMade;
}

export function useMade(): Readonly<Ref<boolean>> {
  return inject(MADE, undefined) ?? ref(true);
}

/** True while the values of a node are visible; others are not drawn. */
export function useReadable(): ComputedRef<boolean> {
  const { stage } = useCanvas();
  const isSeen = inject(SEEN, undefined);
  return computed(() => stage.detail.value !== 'far' && (isSeen?.value ?? true));
}
