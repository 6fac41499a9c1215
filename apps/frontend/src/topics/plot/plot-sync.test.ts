// @vitest-environment happy-dom
import { afterEach, expect, it } from 'vitest';
import { createApp, defineComponent, h, nextTick, ref, shallowRef, type Ref } from 'vue';
import { providePlotSync, sharedRef, usePlotSync, useSharedReading } from './plot-sync.ts';
import type { PlotView } from './plot-view.ts';

interface Plot {
  readonly view: Ref<PlotView>;
  readonly ownX: Ref<number | undefined>;
  readonly shownX: Ref<number | undefined>;
}
let stop: () => void;
afterEach(() => stop());

/** A page with plots of these widths. */
function plotsOf(widths: readonly number[], isOn = ref(true)): Plot[] {
  const plots: Plot[] = [];
  const PlotOf = defineComponent({
    props: { width: { type: Number, required: true } },
    setup({ width }) {
      const sync = usePlotSync();
      const own = ref<PlotView>({ spanMs: width, endMs: undefined });
      const ownX = shallowRef<number>();
      const shownX = shallowRef<number>();
      useSharedReading(sync, ownX, shownX, () => width);
      const view = sharedRef(own, sync?.view, () => sync?.isOn.value === true);
      plots.push({ view, ownX, shownX });
      return () => null;
    },
  });
  const app = createApp({
    setup() {
      providePlotSync(isOn);
      return () => widths.map((width) => h(PlotOf, { width }));
    },
  });
  app.mount(document.createElement('div'));
  stop = () => app.unmount();
  return plots;
}

it('shows one time in all plots: that of the first, then what any of them shows', () => {
  const [first, second] = plotsOf([100, 200]);
  expect(second!.view.value.spanMs).toBe(100);
  second!.view.value = { spanMs: 30, endMs: 7 };
  expect(first!.view.value).toEqual({ spanMs: 30, endMs: 7 });
});

it('lets each plot have its own time when they are not in sync, beginning with the shared one', async () => {
  const isOn = ref(true);
  const [first, second] = plotsOf([100, 200], isOn);
  second!.view.value = { spanMs: 30, endMs: 7 };
  isOn.value = false;
  await nextTick();
  expect(first!.view.value).toEqual({ spanMs: 30, endMs: 7 });
  first!.view.value = { spanMs: 50, endMs: undefined };
  expect(second!.view.value).toEqual({ spanMs: 30, endMs: 7 });
  isOn.value = true;
  expect(second!.view.value.spanMs).toBe(50);
});

it('draws the reading line at the same time in all plots, whatever their width', () => {
  const [first, second] = plotsOf([100, 200]);
  first!.ownX.value = 25;
  expect([first!.shownX.value, second!.shownX.value]).toEqual([25, 50]);
  second!.ownX.value = 180;
  expect([first!.shownX.value, second!.shownX.value]).toEqual([90, 180]);
  expect(first!.ownX.value).toBeUndefined();
  second!.ownX.value = undefined;
  expect([first!.shownX.value, second!.shownX.value]).toEqual([undefined, undefined]);
});

it('keeps the reading line in its plot when they are not in sync', () => {
  const [first, second] = plotsOf([100, 200], ref(false));
  first!.ownX.value = 25;
  expect([first!.shownX.value, second!.shownX.value]).toEqual([25, undefined]);
});
