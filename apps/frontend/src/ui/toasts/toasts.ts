import {
  markRaw,
  onScopeDispose,
  readonly,
  shallowRef,
  type App,
  type Component,
  type InjectionKey,
  type ShallowRef,
} from 'vue';
import { injectOrThrow } from '../../context/inject-or-throw.ts';

/** Short message with at most one action. Not for errors that need a reaction. */
export interface Toast {
  readonly id: number;
  readonly text: string;
  readonly action?: { readonly text: string; readonly run: () => void } | undefined;
  /** Feature that shows it. */
  readonly place?: string | undefined;
  /** Shown in place of the text; its event `done` dismisses the toast. */
  readonly body?: { readonly component: Component; readonly props: object } | undefined;
}

export interface Toasts {
  readonly list: Readonly<ShallowRef<readonly Toast[]>>;
  /** Distance from the bottom, pixels, to keep controls there usable. */
  readonly lift: ShallowRef<number>;
  /** @param place its newest toast replaces the previous one, and is dismissed when the place is left */
  show(text: string, action?: Toast['action'], place?: string): void;
  /** Shows a component that is loaded with what it is about, such as a name to be edited. */
  showBody(component: Component, props: object): void;
  dismiss(id: number): void;
  /** Dismisses the toasts of a place. */
  leave(place: string): void;
}

/** Duration of a toast, milliseconds. */
export const TOAST_MS = 6000;

const TOASTS: InjectionKey<Toasts> = Symbol('toasts');

export function createToasts(): Toasts {
  const list = shallowRef<readonly Toast[]>([]);
  let lastId = 0;
  function add(toast: Omit<Toast, 'id'>, others: readonly Toast[] = list.value): void {
    lastId += 1;
    // At most two at a time.
    list.value = [...others.slice(-1), { id: lastId, ...toast }];
  }
  return {
    list: readonly(list) as Toasts['list'],
    lift: shallowRef(0),
    show(text, action, place) {
      const others = list.value.filter((toast) => place === undefined || toast.place !== place);
      add({ text, action, place }, others);
    },
    showBody: (component, props) =>
      add({ text: '', body: { component: markRaw(component), props } }),
    dismiss(id) {
      list.value = list.value.filter((toast) => toast.id !== id);
    },
    leave(place) {
      if (list.value.some((toast) => toast.place === place))
        list.value = list.value.filter((toast) => toast.place !== place);
    },
  };
}

export function provideToasts(app: App, toasts: Toasts): void {
  app.provide(TOASTS, toasts);
}

export function useToasts(): Toasts {
  return injectOrThrow(TOASTS, 'provideToasts() at the root of the app');
}

/** Toasts of a place, dismissed when the calling component is unmounted. */
export function useToastsOf(place: string): Pick<Toasts, 'show'> {
  const toasts = useToasts();
  onScopeDispose(() => toasts.leave(place));
  return { show: (text, action) => toasts.show(text, action, place) };
}
