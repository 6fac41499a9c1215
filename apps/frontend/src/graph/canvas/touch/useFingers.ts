import { useEventListener } from '@vueuse/core';
import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import type { GraphEditor, Selection } from '../../editing/graph-editor.ts';
import type { Point, PortRef } from '../../model/graph.ts';
import type { CanvasStage } from '../canvas-stage.ts';
import type { ConnectGesture } from '../connect-gesture.ts';
import { Pinch } from './pinch.ts';

/** State and callbacks that touch input uses. */
export interface FingerTargets {
  readonly editor: GraphEditor;
  readonly stage: CanvasStage;
  readonly gesture: ConnectGesture;
  /** Long press with a finger or a pen. */
  held(at: { clientX: number; clientY: number }, element: Element | null): void;
}

/** Duration of a long press that opens the menu, milliseconds. */
export const HOLD_MS = 500;
/** Movement up to which a touch is a tap, pixels. */
const TAP_PX = 10;

/** Gesture of the first finger. Rete pans and drags by itself. */
type Doing =
  | { readonly kind: 'rete' }
  /** Pans without Rete; a tap has its own action. */
  | {
      readonly kind: 'pan';
      readonly view: CanvasStage['view']['value'];
      tap(at: PointerEvent): void;
    }
  /** Finished: ignores the finger until it is lifted. */
  | { readonly kind: 'nothing' };

/**
 * Touch gestures on the canvas: one finger pans, drags or pulls a wire, two zoom; two taps connect; a long press opens
 * the menu. @returns position of a finger in a long press, in pixels of the canvas
 */
export function useFingers({
  editor,
  stage,
  gesture,
  held,
}: FingerTargets): Readonly<ShallowRef<Point | undefined>> {
  const holding = shallowRef<Point>();
  const { container } = stage;
  const fingers = new Map<number, Point>();
  const pinch = new Pinch(stage, () => editor.undo());
  let start: PointerEvent | undefined;
  let doing: Doing = { kind: 'nothing' };
  let before: Selection = editor.selection.value;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let frame = 0;
  let isLettingGo = false;
  /** The last touch was handled: suppress the click that the browser derives from it. */
  let isTaken = false;

  function letGo(pointerId: number): void {
    isLettingGo = true;
    stage.letGo(pointerId);
    isLettingGo = false;
    doing = { kind: 'nothing' };
  }

  function stopHolding(): void {
    clearTimeout(timer);
    cancelAnimationFrame(frame);
    holding.value = undefined;
  }
  function hold(event: PointerEvent, element: Element | null): void {
    // Fields have their own menu.
    if (element?.closest('input, textarea, select')) return;
    const { left, top } = container.getBoundingClientRect();
    holding.value = { x: event.clientX - left, y: event.clientY - top };
    clearTimeout(timer);
    timer = setTimeout(() => {
      // On a busy page the finger may have moved, with its events queued until the next frame.
      frame = requestAnimationFrame(() => {
        stopHolding();
        letGo(event.pointerId);
        gesture.cancel();
        editor.selection.value = before;
        held(event, element);
      });
    }, HOLD_MS);
  }

  function press(event: PointerEvent): void {
    start = event;
    before = editor.selection.value;
    const target = event.target instanceof Element ? event.target : null;
    if (gesture.pull.value !== undefined) {
      event.stopPropagation();
      doing = { kind: 'pan', view: stage.view.value, tap: (at) => gesture.tap(at) };
      return;
    }
    const port = gesture.nearestSocket(event);
    if (port !== undefined) {
      event.stopPropagation();
      gesture.press(event, port);
      doing = { kind: 'rete' };
      hold(event, socketElement(port) ?? target);
      return;
    }
    hold(event, target);
    const hit = target?.closest('.hit, [data-wire-chip]');
    const wire = hit?.closest<HTMLElement>('[data-wire], [data-wire-chip]')?.dataset;
    const id = wire?.['wire'] ?? wire?.['wireChip'];
    if (id === undefined) {
      doing = { kind: 'rete' };
      return;
    }
    event.stopPropagation();
    doing = { kind: 'pan', view: stage.view.value, tap: () => editor.selectWire(id) };
  }

  function socketElement({ node, port }: PortRef): Element | null {
    const mark = `[data-port="${CSS.escape(port)}"]`;
    return stage.elements.get(node)?.querySelector(mark) ?? null;
  }

  useEventListener(
    container,
    'pointerdown',
    (event) => {
      if (event.pointerType === 'pen') {
        start = event;
        before = editor.selection.value;
        doing = { kind: 'rete' };
        const target = event.target instanceof Element ? event.target : null;
        if (event.button === 0 && gesture.pull.value === undefined) hold(event, target);
      }
      if (event.pointerType !== 'touch') return;
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (fingers.size === 1) {
        press(event);
        return;
      }
      event.stopPropagation();
      stopHolding();
      if (fingers.size > 2 || start === undefined) return;
      const isWaiting = gesture.waiting.value !== undefined;
      letGo(start.pointerId);
      if (!isWaiting) gesture.cancel();
      editor.selection.value = before;
      pinch.begin([...fingers.values()], event.timeStamp);
    },
    { capture: true },
  );

  useEventListener(
    window,
    'pointermove',
    (event) => {
      const { pointerId, clientX: x, clientY: y } = event;
      if (fingers.has(pointerId)) fingers.set(pointerId, { x, y });
      if (pinch.isOn) pinch.move([...fingers.values()]);
      if (start?.pointerId !== pointerId) return;
      const [dx, dy] = [x - start.clientX, y - start.clientY];
      if (Math.hypot(dx, dy) <= TAP_PX) return;
      stopHolding();
      if (doing.kind === 'pan') {
        const { view } = doing;
        void stage.look({ ...view, x: view.x + dx, y: view.y + dy });
      }
    },
    { capture: true },
  );

  function lift(event: PointerEvent): void {
    if (isLettingGo) return;
    stopHolding();
    const isOurs = doing.kind !== 'rete';
    isTaken = isOurs;
    const wasFinger = fingers.delete(event.pointerId);
    if (pinch.isOn && fingers.size < 2) pinch.end(event.timeStamp);
    if (start?.pointerId !== event.pointerId) {
      if (wasFinger) event.stopPropagation();
      return;
    }
    const moved = Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY);
    if (doing.kind === 'pan' && event.type === 'pointerup' && moved <= TAP_PX) doing.tap(event);
    // Rete must not handle gestures handled here.
    if (isOurs) event.stopPropagation();
    start = undefined;
    doing = { kind: 'nothing' };
  }
  useEventListener(window, 'pointerup', lift, { capture: true });
  useEventListener(window, 'pointercancel', lift, { capture: true });
  // The mouse events that browsers derive from touches would move the focus out of an open menu.
  useEventListener(
    container,
    'touchend',
    (event) => {
      if (isTaken && event.cancelable) event.preventDefault();
    },
    { passive: false },
  );

  onScopeDispose(stopHolding);
  return holding;
}
