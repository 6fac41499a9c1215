import { onScopeDispose, watch } from 'vue';

/** Capture time of the picture that a video shows, as far as the browser reports it. */
export interface FrameTimes {
  /** On the clock of `performance.now()`; `undefined` without a recent picture. */
  takenMs(): number | undefined;
}

/** Age from which a time no longer belongs to the visible picture, milliseconds. */
const MAX_AGE_MS = 1000;

/** Tracks the capture times of a video's pictures; otherwise the times at which they were ready for display. */
export function useFrameTimes(video: () => HTMLVideoElement | null): FrameTimes {
  let takenMs: number | undefined;
  let end = (): void => undefined;
  watch(
    video,
    (element) => {
      end();
      if (!element || !('requestVideoFrameCallback' in element)) return;
      let handle = 0;
      const note: VideoFrameRequestCallback = (_nowMs, { captureTime, presentationTime }) => {
        takenMs = captureTime ?? presentationTime;
        handle = element.requestVideoFrameCallback(note);
      };
      handle = element.requestVideoFrameCallback(note);
      end = () => element.cancelVideoFrameCallback(handle);
    },
    { immediate: true },
  );
  onScopeDispose(() => end());
  return {
    takenMs() {
      const ageMs = performance.now() - (takenMs ?? -Infinity);
      return ageMs >= 0 && ageMs <= MAX_AGE_MS ? takenMs : undefined;
    },
  };
}
