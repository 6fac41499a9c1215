import {
  computed,
  inject,
  provide,
  shallowRef,
  type ComputedRef,
  type InjectionKey,
  type Ref,
} from 'vue';
import { useCanvas } from '../editor/use-graph-editor.ts';

/** Below this zoom, nodes are a title and a state. */
export const FAR_ZOOM = 0.45;

const SEEN: InjectionKey<Ref<boolean>> = Symbol('seen');

/** One observer for each stage: thousands would cost more than they save. */
const observers = new WeakMap<HTMLElement, IntersectionObserver>();
const listeners = new WeakMap<Element, (isSeen: boolean) => void>();

function observerOf(container: HTMLElement): IntersectionObserver {
  let observer = observers.get(container);
  if (observer === undefined) {
    observer = new IntersectionObserver(
      (entries) => {
        for (const { target, isIntersecting } of entries) listeners.get(target)?.(isIntersecting);
      },
      { root: container, rootMargin: '80px' },
    );
    observers.set(container, observer);
  }
  return observer;
}

/** Whether a node is on the screen, for what is in it. @returns what begins and ends the watch */
export function provideSeen(): { begin(element: Element): void; end(element: Element): void } {
  const { stage } = useCanvas();
  const isSeen = shallowRef(true);
  provide(SEEN, isSeen);
  return {
    begin(element) {
      listeners.set(element, (now) => (isSeen.value = now));
      observerOf(stage.container).observe(element);
    },
    end(element) {
      observerOf(stage.container).unobserve(element);
      listeners.delete(element);
    },
  };
}

/** True while the values of a node can be read: what nobody sees is not drawn. */
export function useReadable(): ComputedRef<boolean> {
  const { stage } = useCanvas();
  const isSeen = inject(SEEN, undefined);
  const isNear = computed(() => stage.view.value.k >= FAR_ZOOM);
  return computed(() => isNear.value && (isSeen?.value ?? true));
}
