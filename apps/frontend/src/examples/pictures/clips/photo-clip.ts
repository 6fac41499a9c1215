import astronaut from '@ubii/vision/photos/astronaut.jpg?url';
import camera from '@ubii/vision/photos/camera.jpg?url';
import chelsea from '@ubii/vision/photos/chelsea.jpg?url';
import coffee from '@ubii/vision/photos/coffee.jpg?url';
import type { Clip } from './clip.ts';

/** Photographs of the built-in clip; rights: `packages/vision/photos/README.md`. */
const PHOTOS = [coffee, astronaut, chelsea, camera];
/** Vertical focus of each when it is cropped, from the top (0) to the bottom (1). */
const FOCUS_Y = [0.4, 0.05, 0.4, 0.2];
/** Duration of each photograph, milliseconds. */
const SHOWN_MS = 5000;
const FADE_MS = 400;
/** Zoom while a photograph is shown, as a share. */
const ZOOM = 0.12;

/** Returns the visible photographs at a time of the clip, with their opacities. */
function clipFrame(
  timeMs: number,
  count: number,
): readonly { readonly index: number; readonly scale: number; readonly alpha: number }[] {
  const turn = Math.floor(timeMs / SHOWN_MS);
  const inside = timeMs - turn * SHOWN_MS;
  const scaleAt = (shownMs: number): number => 1 + (ZOOM * shownMs) / SHOWN_MS;
  const now = { index: turn % count, scale: scaleAt(inside), alpha: 1 };
  if (turn === 0 || inside >= FADE_MS) return [now];
  const before = { index: (turn - 1) % count, scale: scaleAt(SHOWN_MS + inside), alpha: 1 };
  return [before, { ...now, alpha: inside / FADE_MS }];
}

/** Loads the clip of photographs. */
export async function loadPhotoClip(): Promise<Clip> {
  const photos = await Promise.all(
    PHOTOS.map(async (url) => {
      const response = await fetch(url);
      return await createImageBitmap(await response.blob());
    }),
  );
  return {
    draw: (canvas, timeMs) => drawPhotos(canvas, photos, timeMs),
    close() {
      for (const photo of photos) photo.close();
    },
  };
}

/** Draws a frame of the clip; photographs fill the canvas and are cropped. */
function drawPhotos(
  canvas: HTMLCanvasElement,
  photos: readonly ImageBitmap[],
  timeMs: number,
): void {
  const context = canvas.getContext('2d')!;
  for (const { index, scale, alpha } of clipFrame(timeMs, photos.length)) {
    const photo = photos[index]!;
    const fit = Math.max(canvas.width / photo.width, canvas.height / photo.height) * scale;
    const [width, height] = [photo.width * fit, photo.height * fit];
    context.globalAlpha = alpha;
    context.drawImage(
      photo,
      (canvas.width - width) / 2,
      (canvas.height - height) * FOCUS_Y[index]!,
      width,
      height,
    );
  }
  context.globalAlpha = 1;
}
