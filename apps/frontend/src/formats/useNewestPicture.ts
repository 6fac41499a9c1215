import type { Image2D } from '@ubii/proto';
import { onScopeDispose, watch } from 'vue';

type Drawable = ImageBitmap | ImageData;

/**
 * Draws the newest picture. Decodes one at a time; pictures received meanwhile are skipped, not queued.
 *
 * @param decode rejects, or returns undefined, for invalid pictures
 * @param handle called with the decoded picture, and without one on failure; browsers report no reason
 */
export function useNewestPicture(
  image: () => Image2D,
  decode: (image: Image2D) => Promise<Drawable | undefined>,
  handle: (image: Image2D, drawable: Drawable | undefined, isRejected: boolean) => void,
): void {
  let next: Image2D | undefined;
  let isBusy = false;
  async function work(): Promise<void> {
    isBusy = true;
    for (let current = next; current !== undefined; current = next) {
      next = undefined;
      try {
        handle(current, await decode(current), false);
      } catch {
        handle(current, undefined, true);
      }
    }
    isBusy = false;
  }
  watch(
    image,
    (newest) => {
      next = newest;
      if (!isBusy) void work();
    },
    { immediate: true, flush: 'post' },
  );
  onScopeDispose(() => (next = undefined));
}

/** Draws a picture on a canvas of its size, and releases it. */
export function drawPicture(canvas: HTMLCanvasElement | null, drawable: Drawable): void {
  const context = canvas?.getContext('2d');
  if (canvas && context) {
    if (canvas.width !== drawable.width) canvas.width = drawable.width;
    if (canvas.height !== drawable.height) canvas.height = drawable.height;
    if (drawable instanceof ImageData) context.putImageData(drawable, 0, 0);
    else {
      context.clearRect(0, 0, canvas.width, canvas.height);
      context.drawImage(drawable, 0, 0);
    }
  }
  if (!(drawable instanceof ImageData)) drawable.close();
}
