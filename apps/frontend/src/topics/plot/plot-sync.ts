import {
  computed,
  inject,
  provide,
  shallowRef,
  watch,
  type InjectionKey,
  type Ref,
  type ShallowRef,
  type WritableComputedRef,
} from 'vue';
import type { PlotView } from './plot-view.ts';

/** What the plots of a page share while `isOn`: the visible time, the pause, and the reading line. */
export interface PlotSync {
  readonly isOn: Readonly<Ref<boolean>>;
  /** `undefined` before the first plot. */
  readonly view: ShallowRef<PlotView | undefined>;
  readonly isPaused: ShallowRef<boolean | undefined>;
  /** Reading line: the plot that has it, and its position as a share of the width of the plots. */
  readonly reading: ShallowRef<{ readonly by: symbol; readonly share: number } | undefined>;
}

const SYNC: InjectionKey<PlotSync> = Symbol('plots in sync');

/** Provides the shared time for the plots inside the calling component. */
export function providePlotSync(isOn: Readonly<Ref<boolean>>): PlotSync {
  const sync: PlotSync = {
    isOn,
    view: shallowRef(),
    isPaused: shallowRef(),
    reading: shallowRef(),
  };
  // After the plots have taken over what they shared: their watches are synchronous.
  watch(isOn, () => {
    sync.view.value = undefined;
    sync.isPaused.value = undefined;
    sync.reading.value = undefined;
  });
  provide(SYNC, sync);
  return sync;
}

/** @returns `undefined` on pages with one plot */
export const usePlotSync = (): PlotSync | undefined => inject(SYNC, undefined);

/**
 * Returns a value of a plot that is shared with the other plots while `isShared`. A plot that joins takes the shared value;
 * one that leaves keeps it.
 */
export function sharedRef<T>(
  own: Ref<T>,
  shared: Ref<T | undefined> | undefined,
  isShared: () => boolean,
): WritableComputedRef<T> {
  if (!shared) return computed({ get: () => own.value, set: (next) => (own.value = next) });
  watch(
    isShared,
    (is) => {
      if (is) shared.value ??= own.value;
      else own.value = shared.value ?? own.value;
    },
    { immediate: true, flush: 'sync' },
  );
  return computed({
    get: () => (isShared() ? (shared.value ?? own.value) : own.value),
    set(next) {
      if (isShared()) shared.value = next;
      else own.value = next;
    },
  });
}

/**
 * Keeps the reading lines of the plots of a page at one time.
 * @param ownX position of the pointer or keyboard on this plot, pixels; `undefined` elsewhere
 * @param shownX position of the reading line, written here
 */
export function useSharedReading(
  sync: PlotSync | undefined,
  ownX: Ref<number | undefined>,
  shownX: Ref<number | undefined>,
  width: () => number,
): void {
  const by = Symbol('plot');
  watch(
    ownX,
    (x) => {
      if (!sync?.isOn.value) shownX.value = x;
      else if (x !== undefined) sync.reading.value = { by, share: x / width() };
      else if (sync.reading.value?.by === by) sync.reading.value = undefined;
    },
    { flush: 'sync' },
  );
  if (!sync) return;
  watch(
    [sync.reading, width],
    ([reading, now]) => {
      // Another plot has the pointer now.
      if (reading !== undefined && reading.by !== by) ownX.value = undefined;
      shownX.value = reading === undefined ? undefined : reading.share * now;
    },
    { flush: 'sync' },
  );
}
