/** Callbacks for a pointer that is held down. */
export interface PointerFollower {
  move(event: PointerEvent): void;
  /** The pointer was released. */
  drop(event: PointerEvent): void;
  /** Escape, a second finger, or the window lost the focus: restore the state before the drag. */
  cancel(): void;
}

/** Pointer movement up to which a press is a click, pixels; fingers are never quite still. */
const CLICK_PX = 4;
const TAP_PX = 10;

export const isClick = (start: PointerEvent, { clientX, clientY }: PointerEvent): boolean =>
  Math.hypot(clientX - start.clientX, clientY - start.clientY) <
  (start.pointerType === 'touch' ? TAP_PX : CLICK_PX);

/**
 * Follows a pointer from `pointerdown` until its release; the last call is either `drop` or `cancel`. @returns a function
 * that cancels it
 */
export function followPointer(start: PointerEvent, follower: PointerFollower): () => void {
  const listening = new AbortController();
  const options = { signal: listening.signal, capture: true };
  const cancel = (): void => {
    if (listening.signal.aborted) return;
    listening.abort();
    follower.cancel();
  };
  const isOther = ({ pointerId }: PointerEvent): boolean => pointerId !== start.pointerId;
  window.addEventListener(
    'pointermove',
    (event) => {
      if (!isOther(event)) follower.move(event);
    },
    options,
  );
  window.addEventListener(
    'pointerup',
    (event) => {
      if (isOther(event)) return;
      listening.abort();
      follower.drop(event);
    },
    options,
  );
  window.addEventListener(
    'pointercancel',
    (event) => {
      if (!isOther(event)) cancel();
    },
    options,
  );
  window.addEventListener(
    'pointerdown',
    (event) => {
      if (isOther(event)) cancel();
    },
    options,
  );
  window.addEventListener('blur', cancel, { signal: listening.signal });
  window.addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      cancel();
    },
    options,
  );
  return cancel;
}
