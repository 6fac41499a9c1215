import { useEventListener } from '@vueuse/core';
import { shallowRef, type Ref } from 'vue';
import { lengthOf, spanBetween, timeAt } from '../timeline/span.ts';
import type { Timeline } from './useTimeline.ts';

/** What a pointer that is down does. */
type Doing =
  | { readonly kind: 'seek' }
  | { readonly kind: 'loop'; readonly anchorMs: number; readonly x: number; moved: boolean }
  | { readonly kind: 'pan'; lastX: number; moved: boolean }
  | { readonly kind: 'pinch'; distance: number };

const CLICK_PX = 3;
/** One line of a wheel, pixels. */
const LINE_PX = 16;
const ZOOM_PER_PX = 0.0022;

/** Where gestures begin. */
export type GestureArea = 'tracks' | 'ruler';

/**
 * Mouse, pen and fingers on the timeline: dragging seeks, on the ruler or with Shift it marks a loop, the wheel zooms
 * at the pointer. Fingers drag the view along on the tracks, and pinch.
 */
export function useTimelineGestures(
  area: Readonly<Ref<HTMLElement | null>>,
  timeline: Timeline,
  kind: GestureArea,
): void {
  const doing = shallowRef<Doing>();
  const fingers = new Map<number, PointerEvent>();

  const xIn = ({ clientX }: { readonly clientX: number }): number =>
    clientX - (area.value?.getBoundingClientRect().left ?? 0);
  const widthPx = (): number => area.value?.clientWidth ?? 1;
  const timeOf = (event: { readonly clientX: number }): number =>
    timeAt(xIn(event), timeline.span.value, widthPx());
  const distance = (): number => {
    const [a, b] = [...fingers.values()];
    return a && b ? Math.max(10, Math.abs(a.clientX - b.clientX)) : 10;
  };

  function begin(event: PointerEvent): Doing {
    const isTouch = event.pointerType === 'touch';
    if (kind === 'ruler' || event.shiftKey)
      return { kind: 'loop', anchorMs: timeOf(event), x: xIn(event), moved: false };
    if (isTouch) return { kind: 'pan', lastX: xIn(event), moved: false };
    timeline.opened.seek(timeOf(event));
    return { kind: 'seek' };
  }

  useEventListener(area, 'pointerdown', (event: PointerEvent) => {
    if (event.button !== 0) return;
    area.value?.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, event);
    if (fingers.size === 2) doing.value = { kind: 'pinch', distance: distance() };
    else doing.value = begin(event);
  });
  useEventListener(area, 'pointermove', (event: PointerEvent) => {
    const now = doing.value;
    if (now === undefined || !fingers.has(event.pointerId)) return;
    fingers.set(event.pointerId, event);
    if (now.kind === 'seek') timeline.opened.seek(timeOf(event));
    else if (now.kind === 'loop') brush(now, event);
    else if (now.kind === 'pan') pan(now, event);
    else pinch(now);
  });
  function brush(now: Doing & { kind: 'loop' }, event: PointerEvent): void {
    now.moved ||= Math.abs(xIn(event) - now.x) > CLICK_PX;
    if (now.moved) timeline.setLoop(spanBetween(now.anchorMs, timeOf(event)));
  }
  function pan(now: Doing & { kind: 'pan' }, event: PointerEvent): void {
    const x = xIn(event);
    if (!now.moved && Math.abs(x - now.lastX) <= CLICK_PX) return;
    now.moved = true;
    timeline.pan(((now.lastX - x) / widthPx()) * lengthOf(timeline.span.value));
    now.lastX = x;
  }
  function pinch(now: Doing & { kind: 'pinch' }): void {
    const [a, b] = [...fingers.values()];
    if (a === undefined || b === undefined) return;
    const next = distance();
    timeline.zoom(now.distance / next, timeOf({ clientX: (a.clientX + b.clientX) / 2 }));
    now.distance = next;
  }

  function end(event: PointerEvent, isCancelled: boolean): void {
    const now = doing.value;
    if (!fingers.delete(event.pointerId) || now === undefined) return;
    const isClick = (now.kind === 'loop' || now.kind === 'pan') && !now.moved;
    if (isClick && !isCancelled) timeline.opened.seek(timeOf(event));
    doing.value = undefined;
  }
  useEventListener(area, 'pointerup', (event: PointerEvent) => end(event, false));
  useEventListener(area, 'pointercancel', (event: PointerEvent) => end(event, true));

  useEventListener(
    area,
    'wheel',
    (event: WheelEvent) => {
      event.preventDefault();
      const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE_PX : 1;
      const sideways = event.shiftKey ? event.deltaY || event.deltaX : event.deltaX;
      const isSideways = event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY);
      if (isSideways) timeline.pan(((sideways * unit) / widthPx()) * lengthOf(timeline.span.value));
      else timeline.zoom(Math.exp(event.deltaY * unit * ZOOM_PER_PX), timeOf(event));
    },
    { passive: false },
  );
}
