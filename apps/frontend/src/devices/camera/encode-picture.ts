import { Image2DDataFormat, type Image2D } from '@ubii/proto';
import { JpegEncoder } from './jpeg-encoder.ts';

/** Raw pixels, which every program can read, or a JPEG file in the data, which is about ten times smaller. */
export type PictureEncoding = 'RGB8' | 'RGBA8' | 'GRAY8' | 'JPEG';

/** Highest data rate of a camera, bytes per second, so that a phone's Wi-Fi has capacity left. */
export const MAX_BYTES_PER_SECOND = 8_000_000;

/** Source of pictures, with its size in pixels: a video, a photograph, a canvas. */
export interface PictureSource {
  readonly element: CanvasImageSource;
  readonly width: number;
  readonly height: number;
  /**
   * Capture time of the picture on the clock of `performance.now()`; `undefined` where the browser does not report it.
   */
  readonly takenMs?: number | undefined;
}

/** Returns a video as a source; undefined before its first picture. */
export function videoSource(
  video: HTMLVideoElement | null,
  takenMs?: number,
): PictureSource | undefined {
  if (!video || video.videoWidth === 0) return undefined;
  return { element: video, width: video.videoWidth, height: video.videoHeight, takenMs };
}

export interface PictureSettings {
  /** Width of the published picture, pixels; the height keeps the aspect ratio. */
  width: number;
  /** Wanted rate of pictures, Hz. */
  rateHz: number;
  encoding: PictureEncoding;
  /** Quality of a JPEG, 0 to 1. */
  quality: number;
}

/** Returns the wanted rate, or a lower one that keeps within `MAX_BYTES_PER_SECOND`. */
export function affordableRate(wantedHz: number, pictureBytes: number): number {
  if (pictureBytes <= 0) return wantedHz;
  return Math.min(wantedHz, MAX_BYTES_PER_SECOND / pictureBytes);
}

/** Scales a size down to a width, keeping the aspect ratio; never enlarges. */
export function sizeWithin(
  source: { readonly width: number; readonly height: number },
  width: number,
): { readonly width: number; readonly height: number } {
  const scale = Math.min(1, width / source.width);
  return {
    width: Math.max(1, Math.round(source.width * scale)),
    height: Math.max(1, Math.round(source.height * scale)),
  };
}

/** Converts pixels of a canvas to another layout. */
export function packPixels(
  rgba: Uint8ClampedArray,
  layout: Exclude<PictureEncoding, 'JPEG'>,
): Uint8Array {
  if (layout === 'RGBA8') return new Uint8Array(rgba);
  const count = rgba.length / 4;
  const channels = layout === 'RGB8' ? 3 : 1;
  const packed = new Uint8Array(count * channels);
  for (let i = 0; i < count; i++) {
    const red = rgba[i * 4]!;
    const green = rgba[i * 4 + 1]!;
    const blue = rgba[i * 4 + 2]!;
    if (channels === 1) {
      // Luma (BT.601), in 256ths.
      packed[i] = (77 * red + 150 * green + 29 * blue) >> 8;
    } else {
      packed[i * 3] = red;
      packed[i * 3 + 1] = green;
      packed[i * 3 + 2] = blue;
    }
  }
  return packed;
}

/** Encodes pictures to records, one at a time. Close it after use. */
export class PictureEncoder {
  readonly #canvas = document.createElement('canvas');
  /** Undefined before the first JPEG, and where workers cannot encode. */
  #jpegs: JpegEncoder | undefined;
  #hasWorker = JpegEncoder.isSupported();

  /** @throws {Error} if the browser cannot encode JPEG */
  async encode(
    source: PictureSource,
    { width: maxWidth, encoding, quality }: Readonly<PictureSettings>,
  ): Promise<Image2D> {
    const { width, height } = sizeWithin(source, maxWidth);
    const canvas = this.#canvas;
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const context = canvas.getContext('2d', { willReadFrequently: true })!;
    context.drawImage(source.element, 0, 0, width, height);
    if (encoding === 'JPEG' && this.#hasWorker) {
      const jpegs = (this.#jpegs ??= new JpegEncoder());
      // Chromium may never resolve for a video whose camera was reopened.
      const picture = await createImageBitmap(canvas);
      try {
        const data = await jpegs.encode(picture, { width, height, quality });
        return { width, height, dataFormat: Image2DDataFormat.RGB8, data };
      } catch (error) {
        // From the next picture on, encode on the main thread.
        this.#hasWorker = false;
        this.close();
        throw error;
      }
    }
    if (encoding !== 'JPEG') {
      const data = packPixels(context.getImageData(0, 0, width, height).data, encoding);
      return { width, height, dataFormat: Image2DDataFormat[encoding], data };
    }
    const blob = await new Promise<Blob | null>((resolve) =>
      canvas.toBlob(resolve, 'image/jpeg', quality),
    );
    if (!blob) throw new Error('The browser could not encode the picture.');
    const data = new Uint8Array(await blob.arrayBuffer());
    return { width, height, dataFormat: Image2DDataFormat.RGB8, data };
  }

  close(): void {
    this.#jpegs?.close();
    this.#jpegs = undefined;
  }
}
