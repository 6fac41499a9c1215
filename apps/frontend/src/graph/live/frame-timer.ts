import { onScopeDispose } from 'vue';

/**
 * Measures how long a frame occupies the main thread, including layout and paint; stops with the calling scope. Call
 * the returned function in an animation frame callback.
 */
export function createFrameTimer(took: (frameMs: number) => void): () => void {
  const { port1, port2 } = new MessageChannel();
  let beganMs = 0;
  // The message is delivered when the frame that sent it is done.
  port1.onmessage = () => took(performance.now() - beganMs);
  onScopeDispose(() => port1.close());
  return () => {
    beganMs = performance.now();
    port2.postMessage(undefined);
  };
}
