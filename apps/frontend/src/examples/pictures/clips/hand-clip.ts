import { handPicture } from '@ubii/vision/hand-picture';
import type { Clip } from './clip.ts';

const PICTURE = { width: 420, height: 620 };
const HAND = { x: 60, y: 40, side: 300 };
/** The hand swings about its wrist: amplitude in radians, period in milliseconds. */
const ANGLE = 0.3;
const WAVE_MS = 6000;

/** Draws a hand and loads it as a clip in which it waves. */
export async function loadHandClip(): Promise<Clip> {
  const { width, height, data } = handPicture(PICTURE.width, PICTURE.height, HAND);
  const pixels = new ImageData(width, height);
  for (let pixel = 0; pixel < width * height; pixel++) {
    pixels.data.set(data.subarray(pixel * 3, pixel * 3 + 3), pixel * 4);
    pixels.data[pixel * 4 + 3] = 255;
  }
  const hand = await createImageBitmap(pixels);
  return {
    draw(canvas, timeMs) {
      const context = canvas.getContext('2d')!;
      // The corner pixel has the colour of the background.
      context.drawImage(hand, 0, 0, 1, 1, 0, 0, canvas.width, canvas.height);
      context.save();
      context.translate(canvas.width / 2, height);
      context.rotate(ANGLE * Math.sin((timeMs / WAVE_MS) * 2 * Math.PI));
      context.drawImage(hand, -width / 2, -height);
      context.restore();
    },
    close: () => hand.close(),
  };
}
