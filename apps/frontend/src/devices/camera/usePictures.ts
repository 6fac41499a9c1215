import type { Image2D } from '@ubii/proto';
import { shallowReactive, watch } from 'vue';
import { RateMeter } from '../sensors/rate-meter.ts';
import {
  affordableRate,
  PictureEncoder,
  type PictureSettings,
  type PictureSource,
} from './encode-picture.ts';

/** What was measured of the last pictures; all `undefined` while none are sent. */
export interface PictureMeasures {
  width: number | undefined;
  height: number | undefined;
  bytes: number | undefined;
  /** Drawing, scaling and packing one picture, milliseconds. */
  encodeMs: number | undefined;
  rateHz: number | undefined;
  /** Fewer than wanted, to keep within the bound on bytes. */
  isSlowed: boolean;
  /** When the last one left, on the clock of `performance.now()`. */
  sentAtMs: number | undefined;
}

const NOTHING: PictureMeasures = {
  width: undefined,
  height: undefined,
  bytes: undefined,
  encodeMs: undefined,
  rateHz: undefined,
  isSlowed: false,
  sentAtMs: undefined,
};

/** Takes pictures of a source at a rate, one at a time, while they are wanted. */
export function usePictures(options: {
  readonly source: () => PictureSource | undefined;
  readonly isWanted: () => boolean;
  readonly settings: Readonly<PictureSettings>;
  /** @param ageMs since the picture was taken */
  readonly publish: (image: Image2D, ageMs: number) => void;
}) {
  const measures = shallowReactive<PictureMeasures>({ ...NOTHING });

  watch(
    options.isWanted,
    (isWanted, _before, onCleanup) => {
      if (!isWanted) return;
      const encoder = new PictureEncoder();
      const meter = new RateMeter();
      let isOver = false;
      let timer: ReturnType<typeof setTimeout> | undefined;

      async function takeOne(): Promise<void> {
        const beginMs = performance.now();
        const source = options.source();
        let rateHz = options.settings.rateHz;
        if (source) {
          const image = await encoder.encode(source, options.settings);
          if (isOver) return;
          options.publish(image, performance.now() - beginMs);
          rateHz = affordableRate(rateHz, image.data.length);
          note(image, beginMs, rateHz < options.settings.rateHz);
        }
        const passedMs = performance.now() - beginMs;
        timer = setTimeout(run, Math.max(0, 1000 / rateHz - passedMs));
      }

      function note(image: Image2D, beginMs: number, isSlowed: boolean): void {
        const nowMs = performance.now();
        meter.note(nowMs);
        Object.assign(measures, {
          width: image.width,
          height: image.height,
          bytes: image.data.length,
          encodeMs: nowMs - beginMs,
          rateHz: meter.rateHz(nowMs),
          isSlowed,
          sentAtMs: nowMs,
        });
      }

      function run(): void {
        // One that could not be made is let go of; the next is tried at its time.
        takeOne().catch(() => {
          if (!isOver) timer = setTimeout(run, 1000 / options.settings.rateHz);
        });
      }
      run();
      onCleanup(() => {
        isOver = true;
        clearTimeout(timer);
        Object.assign(measures, NOTHING);
      });
    },
    { flush: 'post' },
  );
  return measures;
}
