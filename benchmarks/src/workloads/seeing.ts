import { PHOTOS } from '@ubii/vision/testing';
import { findChromium, IN_CHROMIUM } from '../browser/chromium.ts';
import { descendantPids } from '../cpu-time.ts';
import { accuracyOf, type Accuracy } from '../seeing/accuracy.ts';
import type { DetectionBackend } from '../seeing/library-messages.ts';
import { openSeeingBrowser, type SeeingBrowser } from '../seeing/seeing-browser.ts';
import type { SeeingSubject } from '../seeing/seeing-page.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Subject, Workload } from '../measuring/workload.ts';

const REFERENCE: SeeingSubject = '@vladmandic/human';
const MODULE: SeeingSubject = 'object-detection';
/** 512 × 512 pixels: neither of the two scales it. */
const PHOTO = { file: 'camera.jpg', expected: 'person' };
/** Detections are slower than what other workloads measure. */
const LENGTH_FACTOR = { wasm: 4, webgl: 12, webgpu: 12 } as const;

/** Detection by the module in a worker of a page, beside the library of its detector in one. */
function seeing(backend: DetectionBackend): Workload {
  return {
    name: `seeing-${backend}`,
    group: 'seeing',
    title: `Objects in a photograph of 512 x 512 pixels in Chromium, CenterNet, ${backend}`,
    figures: [
      {
        key: 'p50Ms',
        label: 'p50',
        unit: 'ms',
        isHigherBetter: false,
        goals: { [MODULE]: 1.15 },
      },
      { key: 'p99Ms', label: 'p99', unit: 'ms', isHigherBetter: false, goals: {} },
      { key: 'rateHz', label: 'rate', unit: 'Hz', isHigherBetter: true, goals: {} },
      {
        key: 'frameP95Ms',
        label: 'frames of the page, p95',
        unit: 'ms',
        isHigherBetter: false,
        goals: {},
        bounds: { [MODULE]: 33.4 },
      },
      {
        key: 'precision',
        label: 'precision',
        unit: '',
        isHigherBetter: true,
        goals: { [MODULE]: 1 },
      },
      { key: 'recall', label: 'recall', unit: '', isHigherBetter: true, goals: { [MODULE]: 1 } },
    ],
    reference: REFERENCE,
    ...IN_CHROMIUM,
    open: async ({ parts }) => {
      const browser = await parts.get('seeing browser', () => openSeeingBrowser(findChromium()!));
      const subjects = [REFERENCE, MODULE];
      const accuracies = new Map<string, Accuracy>();
      // The first detection of each compiles what the next ones use.
      for (const name of subjects) accuracies.set(name, await accuracyIn(browser, name, backend));
      return subjects.map((name): Subject => ({
        name,
        pids: [],
        measure: (options) => measureIn(browser, name, backend, accuracies.get(name)!, options),
      }));
    },
  };
}

/** By backend. Software WebGL is slow, but what the module adds to it can be compared; software WebGPU takes over 10 s for its first picture, the limit of a call. */
export const SEEING: readonly Workload[] = [
  seeing('wasm'),
  seeing('webgl'),
  {
    ...seeing('webgpu'),
    whyNot: () =>
      IN_CHROMIUM.whyNot?.() ??
      (process.env['UBII_BENCH_GPU'] === '1'
        ? undefined
        : 'WebGPU needs a graphics card; set UBII_BENCH_GPU=1 where there is one'),
  },
];

async function accuracyIn(
  browser: SeeingBrowser,
  subject: SeeingSubject,
  backend: DetectionBackend,
): Promise<Accuracy> {
  const files = PHOTOS.map(({ file }) => file);
  const seen = await browser.see(subject, backend, files);
  return accuracyOf(PHOTOS.map(({ file, objects }) => ({ seen: seen[file]!, there: objects })));
}

async function measureIn(
  browser: SeeingBrowser,
  subject: SeeingSubject,
  backend: DetectionBackend,
  accuracy: Accuracy,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const durationMs = measureMs * LENGTH_FACTOR[backend];
  const stopLap = startLap(() => descendantPids(process.pid));
  const result = await browser.measure(subject, backend, PHOTO, {
    warmUpMs,
    measureMs: durationMs,
  });
  const { otherCpuShare } = stopLap();
  return {
    figures: {
      p50Ms: result.p50Us / 1000,
      p99Ms: result.p99Us / 1000,
      rateHz: (result.count / durationMs) * 1000,
      frameP95Ms: result.frameP95Ms,
      ...accuracy,
    },
    otherCpuShare,
    deliveries: result.count,
    faults: result.faults,
  };
}
