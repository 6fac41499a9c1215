import { inject, readonly, shallowRef, type App, type InjectionKey, type ShallowRef } from 'vue';

/** One line for a moment, with at most one action. Never for errors a person must act on. */
export interface Toast {
  readonly id: number;
  readonly text: string;
  readonly action?: { readonly text: string; readonly run: () => void } | undefined;
}

export interface Toasts {
  readonly list: Readonly<ShallowRef<readonly Toast[]>>;
  /** How far up from the bottom they stand, pixels: what is there stays in reach. */
  readonly lift: ShallowRef<number>;
  show(text: string, action?: Toast['action']): void;
  dismiss(id: number): void;
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
    show(text, action) {
      lastId += 1;
      // Two are read, more are noise.
      list.value = [...list.value.slice(-1), { id: lastId, text, action }];
    },
    dismiss(id) {
      list.value = list.value.filter((toast) => toast.id !== id);
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
