/** What happens to a pointer that is held down. */
export interface PointerFollower {
  move(event: PointerEvent): void;
  /** It was let go. */
  drop(event: PointerEvent): void;
  /** Escape, a second finger, or the window was left: everything as it was. */
  cancel(): void;
}

/** Pointers that move less than this have clicked, pixels; fingers are never quite still. */
const CLICK_PX = 4;
const TAP_PX = 10;

export const isClick = (start: PointerEvent, { clientX, clientY }: PointerEvent): boolean =>
  Math.hypot(clientX - start.clientX, clientY - start.clientY) <
  (start.pointerType === 'touch' ? TAP_PX : CLICK_PX);

/**
 * Follows a pointer that went down until it is let go; either `drop` or `cancel` is the last that is
 * called. @returns what cancels it
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
