/** Merges calls into one per animation frame. In a hidden page, the call waits until it is visible. */
export function perFrame(
  fn: () => void,
  atFrame: (fn: () => void) => void = (next) => void requestAnimationFrame(next),
): () => void {
  let isScheduled = false;
  return () => {
    if (isScheduled) return;
    isScheduled = true;
    atFrame(() => {
      isScheduled = false;
      fn();
    });
  };
}
