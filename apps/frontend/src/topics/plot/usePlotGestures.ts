import { shallowRef, type Ref, type ShallowRef } from 'vue';
import { panBy, zoomBy, zoomTo, type PlotView, type ViewBounds } from './plot-view.ts';
import type { PlotBox, ShownTime } from './useTimePlot.ts';

/** Range being drawn with the pointer, pixels within the box. */
export interface Stretch {
  readonly fromX: number;
  readonly toX: number;
}

/** State that gestures change. */
export interface GestureTarget {
  readonly view: Ref<PlotView>;
  readonly box: Readonly<Ref<PlotBox>>;
  readonly shown: Readonly<Ref<ShownTime>>;
  readonly readingX: ShallowRef<number | undefined>;
  bounds(): ViewBounds;
  /** A time was clicked. */
  pick(timeMs: number): void;
  /** Returns to the newest data. */
  follow(): void;
}

/** Movement up to which a press is a click, pixels. */
const DRAG_FROM = 5;
/** Zoom factor per notch of the wheel. */
const WHEEL_STEP = 1.2;
const NOTCH = 100;

/**
 * Mouse and pen: dragging zooms into a range, with Shift or the middle button it pans; the wheel zooms, horizontally it
 * pans. Touch: one finger pans, two zoom. A click selects a time, a double-click returns to the newest data.
 */
export function usePlotGestures(target: GestureTarget): {
  readonly stretch: Readonly<ShallowRef<Stretch | undefined>>;
  handleDown(event: PointerEvent): void;
  handleMove(event: PointerEvent): void;
  handleUp(event: PointerEvent): void;
  handleCancel(event: PointerEvent): void;
  handleLeave(event: PointerEvent): void;
  handleWheel(event: WheelEvent): void;
} {
  const { view, box, shown, readingX } = target;
  const stretch = shallowRef<Stretch>();
  /** Last positions of pressed fingers and buttons, by pointer id. */
  const down = new Map<number, number>();
  let drag: { readonly kind: 'zoom' | 'pan'; readonly fromX: number; moved: boolean } | undefined;

  const xOf = (event: PointerEvent | WheelEvent): number => {
    const { left } = (event.currentTarget as Element).getBoundingClientRect();
    return Math.min(box.value.width, Math.max(0, event.clientX - left));
  };
  const msPerPixel = (): number => view.value.spanMs / box.value.width;
  const timeAt = (x: number): number =>
    shown.value.startMs + (x / box.value.width) * (shown.value.endMs - shown.value.startMs);

  function handleDown(event: PointerEvent): void {
    if (event.button > 1) return;
    const element = event.currentTarget as HTMLElement;
    element.setPointerCapture(event.pointerId);
    const x = xOf(event);
    down.set(event.pointerId, x);
    const isPan = event.pointerType === 'touch' || event.shiftKey || event.button === 1;
    if (event.button === 1) event.preventDefault();
    if (down.size === 1) drag = { kind: isPan ? 'pan' : 'zoom', fromX: x, moved: false };
    else {
      stretch.value = undefined;
      if (drag) drag.moved = true;
    }
  }

  function handleMove(event: PointerEvent): void {
    const x = xOf(event);
    const before = down.get(event.pointerId);
    if (before === undefined || !drag) {
      if (event.pointerType !== 'touch') readingX.value = x;
      return;
    }
    if (down.size === 2) return pinch(event.pointerId, x);
    if (!drag.moved && Math.abs(x - drag.fromX) < DRAG_FROM) return;
    drag.moved = true;
    readingX.value = undefined;
    if (drag.kind === 'pan') {
      view.value = panBy(view.value, (before - x) * msPerPixel(), target.bounds());
      down.set(event.pointerId, x);
    } else stretch.value = { fromX: drag.fromX, toX: x };
  }

  /** Zooms and pans so that the times under two fingers stay there. */
  function pinch(moved: number, x: number): void {
    const other = [...down].find(([id]) => id !== moved);
    const before = down.get(moved)!;
    down.set(moved, x);
    if (!other) return;
    const [, still] = other;
    const was = Math.abs(before - still);
    const is = Math.abs(x - still);
    if (was < 8 || is < 8) return;
    view.value = zoomBy(view.value, was / is, timeAt((x + still) / 2), target.bounds());
  }

  function handleUp(event: PointerEvent): void {
    if (!down.delete(event.pointerId) || !drag) return;
    const x = xOf(event);
    if (down.size > 0) return;
    const { kind, fromX, moved } = drag;
    drag = undefined;
    stretch.value = undefined;
    if (!moved) {
      readingX.value = x;
      target.pick(timeAt(x));
    } else if (kind === 'zoom') {
      view.value = zoomTo(timeAt(fromX), timeAt(x), target.bounds());
    }
  }

  function handleCancel(event: PointerEvent): void {
    down.delete(event.pointerId);
    if (down.size === 0) drag = undefined;
    stretch.value = undefined;
  }

  function handleWheel(event: WheelEvent): void {
    event.preventDefault();
    const isSideways = event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY);
    const delta = isSideways && event.deltaX !== 0 ? event.deltaX : event.deltaY;
    const scale = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 33 : 1;
    const notches = (delta * scale) / NOTCH;
    const x = xOf(event);
    view.value = isSideways
      ? panBy(view.value, (notches * view.value.spanMs) / 10, target.bounds())
      : zoomBy(view.value, WHEEL_STEP ** notches, timeAt(x), target.bounds());
  }

  return {
    stretch,
    handleDown,
    handleMove,
    handleUp,
    handleCancel,
    handleLeave: (event) => {
      if (event.pointerType !== 'touch') readingX.value = undefined;
    },
    handleWheel,
  };
}
