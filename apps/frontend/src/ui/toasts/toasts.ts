import {
  inject,
  onScopeDispose,
  readonly,
  shallowRef,
  type App,
  type InjectionKey,
  type ShallowRef,
} from 'vue';

/** One line for a moment, with at most one action. Never for errors a person must act on. */
export interface Toast {
  readonly id: number;
  readonly text: string;
  readonly action?: { readonly text: string; readonly run: () => void } | undefined;
  /** The part of the product that it is about. */
  readonly place?: string | undefined;
}

export interface Toasts {
  readonly list: Readonly<ShallowRef<readonly Toast[]>>;
  /** How far up from the bottom they stand, pixels: what is there stays in reach. */
  readonly lift: ShallowRef<number>;
  /** @param place its newest toast replaces the one before, and goes when the place is left */
  show(text: string, action?: Toast['action'], place?: string): void;
  dismiss(id: number): void;
  /** Dismisses what is about a place. */
  leave(place: string): void;
}

/** How long a toast stays, milliseconds. */
export const TOAST_MS = 6000;

const TOASTS: InjectionKey<Toasts> = Symbol('toasts');

export function createToasts(): Toasts {
  const list = shallowRef<readonly Toast[]>([]);
  let lastId = 0;
  return {
    list: readonly(list) as Toasts['list'],
    lift: shallowRef(0),
    show(text, action, place) {
      lastId += 1;
      const others = list.value.filter((toast) => place === undefined || toast.place !== place);
      // Two are read, more are noise.
      list.value = [...others.slice(-1), { id: lastId, text, action, place }];
    },
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
  const toasts = inject(TOASTS);
  if (!toasts) throw new Error('useToasts() needs provideToasts() at the root of the app.');
  return toasts;
}

/** Toasts about a place, which go with the component that shows them. */
export function useToastsOf(place: string): Pick<Toasts, 'show'> {
  const toasts = useToasts();
  onScopeDispose(() => toasts.leave(place));
  return { show: (text, action) => toasts.show(text, action, place) };
}
