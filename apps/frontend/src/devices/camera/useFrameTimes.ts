import { onScopeDispose, watch } from 'vue';

/** The moment at which the picture that a video shows was taken, as far as the browser tells. */
export interface FrameTimes {
  /** On the clock of `performance.now()`; `undefined` without a picture of late. */
  takenMs(): number | undefined;
}

/** What is older than this is no moment of the picture that is seen, milliseconds. */
const MAX_AGE_MS = 1000;

/** Follows the pictures of a video: when the camera took them, else when they were ready to be shown. */
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
