import { onScopeDispose } from 'vue';

/**
 * Says how long a frame held the page's thread, until it was laid out and painted; ends with the
 * calling scope. Call what it returns in a callback of an animation frame.
 */
export function createFrameTimer(took: (frameMs: number) => void): () => void {
  const { port1, port2 } = new MessageChannel();
  let beganMs = 0;
  // A message is read when the frame that sent it is done.
  port1.onmessage = () => took(performance.now() - beganMs);
  onScopeDispose(() => port1.close());
  return () => {
    beganMs = performance.now();
    port2.postMessage(undefined);
  };
}
