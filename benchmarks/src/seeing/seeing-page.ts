/** Script of the page: has pictures detected by a module, and by the library of its detector, on request. */
import { createBrowserSandboxes } from '@ubii/pm-sandbox/browser';
import { CallSeries, type Callee } from '../calls/call-series.ts';
import { percentile } from '../statistics.ts';
import type { Sighting } from './accuracy.ts';
import { openLibrary } from './call-library.ts';
import { openDetector } from './call-module.ts';
import type { Detect, Pixels } from './detect.ts';
import type { DetectionBackend } from './library-messages.ts';

/** The measured detector. */
export type SeeingSubject = '@vladmandic/human' | 'object-detection';

/** Result of a series of detections in the page. */
export interface SeeingResult extends ReturnType<CallSeries<unknown, unknown>['result']> {
  /** From one frame of the page to the next meanwhile, ms. */
  readonly frameP95Ms: number;
}

const sandboxes = createBrowserSandboxes();
const detectors = new Map<string, Promise<Detect>>();

function detectorOf(subject: SeeingSubject, backend: DetectionBackend): Promise<Detect> {
  const id = `${subject} ${backend}`;
  let detector = detectors.get(id);
  if (detector === undefined) {
    detector =
      subject === 'object-detection'
        ? openDetector(sandboxes, backend)
        : Promise.resolve(openLibrary(backend));
    detectors.set(id, detector);
  }
  return detector;
}

async function readPixels(file: string): Promise<Pixels> {
  const bitmap = await createImageBitmap(await (await fetch(`/photos/${file}`)).blob());
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d')!;
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return { file, width, height, rgba: context.getImageData(0, 0, width, height).data };
}

/** Detects the objects in each of the photographs. */
async function see(
  subject: SeeingSubject,
  backend: DetectionBackend,
  files: readonly string[],
): Promise<Record<string, readonly Sighting[]>> {
  const detect = await detectorOf(subject, backend);
  const seen: Record<string, readonly Sighting[]> = {};
  for (const file of files) seen[file] = await detect(await readPixels(file));
  return seen;
}

/** Has one photograph looked at again and again; `expected` is the one class that is in it. */
async function measure(
  subject: SeeingSubject,
  backend: DetectionBackend,
  { file, expected }: { readonly file: string; readonly expected: string },
  { warmUpMs, measureMs }: { readonly warmUpMs: number; readonly measureMs: number },
): Promise<SeeingResult> {
  const detect = await detectorOf(subject, backend);
  const picture = await readPixels(file);
  const callee: Callee<Pixels, readonly Sighting[]> = {
    sequence: 0,
    // Both give the pixels away.
    prepare: () => ({ ...picture, rgba: picture.rgba.slice() }),
    call: detect,
    isRight: (seen) => seen.length === 1 && seen[0]!.class === expected,
  };
  const series = new CallSeries(callee);
  await series.run(warmUpMs);
  const endFrames = watchFrames();
  await series.run(measureMs);
  return {
    ...series.result(),
    frameP95Ms: percentile(
      endFrames().sort((a, b) => a - b),
      0.95,
    ),
  };
}

/** @returns stops, and gives the times between frames, ms */
function watchFrames(): () => number[] {
  const times: number[] = [];
  let isOn = true;
  requestAnimationFrame(function frame(nowMs) {
    times.push(nowMs);
    if (isOn) requestAnimationFrame(frame);
  });
  return () => {
    isOn = false;
    return times.slice(1).map((timeMs, index) => timeMs - times[index]!);
  };
}

/** Interface for the benchmark at `window.seeing`. */
export interface Seeing {
  see: typeof see;
  measure: typeof measure;
}

Object.assign(globalThis, { seeing: { see, measure } satisfies Seeing });
