import { setTimeout as sleep } from 'node:timers/promises';

import { MasterProcess } from '@ubii/harness';

import { startBrowserCpu, IN_CHROMIUM } from '../browser/chromium.ts';
import { descendantPids } from '../cpu-time.ts';
import {
  circle,
  startCanvasBrowser,
  type CanvasPage,
  type Point,
  type CanvasBrowser,
} from '../graph/canvas-page.ts';
import { serveBareCanvas } from '../graph/serve-bare-canvas.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type {
  FigureInfo,
  Measurement,
  MeasureOptions,
  Subject,
  Workload,
} from '../measuring/workload.ts';
import {
  MINUTES,
  TOPICS,
  writeLongRecording,
  type LongRecording,
} from '../recordings/long-recording.ts';
import { percentile } from '../statistics.ts';

/** What is done with a timeline while its frames are counted. */
interface TimelineGesture {
  readonly key: string;
  readonly label: string;
  perform(canvas: CanvasPage, middle: Point, forMs: number): Promise<void>;
}

const WHEEL_PX = 100;
const WHEEL_MS = 16;
/** Turns of the wheel in one direction, before it goes back. */
const TURNS = 12;
const SEEK_PX = 250;

/** Turns the wheel in one direction and back. */
async function wheel({ page }: CanvasPage, forMs: number, isSideways: boolean): Promise<void> {
  const untilMs = performance.now() + forMs;
  for (let turn = 0; performance.now() < untilMs || turn % (2 * TURNS) !== TURNS; turn += 1) {
    const by = turn % (2 * TURNS) < TURNS ? -WHEEL_PX : WHEEL_PX;
    await Promise.all([
      page.mouse.wheel(isSideways ? by : 0, isSideways ? 0 : by),
      sleep(WHEEL_MS),
    ]);
  }
}

/** Each is measured for itself. All but the first are done closer, where tracks are drawn from tiles. */
const TIMELINE_GESTURES: readonly TimelineGesture[] = [
  {
    key: 'zoom',
    label: 'zoom',
    async perform(canvas, { x, y }, forMs) {
      await canvas.page.mouse.move(x, y);
      await wheel(canvas, forMs, false);
    },
  },
  {
    key: 'pan',
    label: 'pan',
    async perform(canvas, { x, y }, forMs) {
      await canvas.page.mouse.move(x, y);
      await wheel(canvas, forMs, true);
    },
  },
  {
    key: 'seek',
    label: 'seek by dragging',
    async perform(canvas, middle, forMs) {
      const { mouse } = canvas.page;
      await mouse.move(middle.x, middle.y);
      await mouse.down();
      await circle(canvas, middle, SEEK_PX, forMs, () => Promise.resolve());
      await mouse.move(middle.x + SEEK_PX, middle.y);
      await mouse.up();
    },
  },
  {
    key: 'play',
    label: 'playing',
    async perform({ page }, _middle, forMs) {
      await page.keyboard.press('Space');
      await sleep(forMs);
      await page.keyboard.press('Space');
    },
  },
];

const REFERENCE = 'bare page';
const TIMELINE = 'timeline';
const OPEN_TIMEOUT_MS = 120_000;
/** A gesture takes longer than what other workloads measure at a time. */
const LENGTH_FACTOR = 3;
/** A frame of a screen with 60 Hz, and two, in the steps in which browsers tell times, milliseconds. */
const FRAME_MS = 16.7;
const TWO_FRAMES_MS = 33.4;
const SETTLE_MS = 1000;

function figure(key: string, label: string, unit: string, bound?: number): FigureInfo {
  const bounds: Record<string, number> = bound === undefined ? {} : { [TIMELINE]: bound };
  return { key, label, unit, isHigherBetter: false, goals: {}, bounds };
}

/** A recording, opened as a file on its page: zoomed, panned, scrubbed and played, beside plain boxes and lines. */
export const recordingTimeline: Workload = {
  name: 'recording-timeline',
  group: 'recording-timeline',
  title: `The timeline of a recording of ${MINUTES} minutes with ${TOPICS} topics`,
  figures: [
    figure('openMs', 'until the tracks are there', 'ms'),
    figure('readMs', 'until all of it was read', 'ms'),
    ...TIMELINE_GESTURES.flatMap(({ key, label }) => [
      figure(`${key}P50Ms`, `${label}, frame p50`, 'ms', FRAME_MS),
      figure(`${key}P95Ms`, `${label}, frame p95`, 'ms', TWO_FRAMES_MS),
      figure(`${key}MainMs`, `${label}, main thread a frame`, 'ms'),
    ]),
  ],
  reference: REFERENCE,
  ...IN_CHROMIUM,
  open: async ({ parts, master: file, profileDir }) => {
    const master = await parts.get('master', () =>
      MasterProcess.start({ program: file, profileDir }),
    );
    const browser = await parts.get('browser', startCanvasBrowser);
    const bare = await parts.get('bare canvas', serveBareCanvas);
    const recording = await parts.get('long recording', writeLongRecording);
    return [
      subject(REFERENCE, master, async () => {
        const canvas = await browser.open(bare.url(TOPICS));
        const openMs = await canvas.watch('ready', TOPICS);
        return { canvas, openMs, readMs: openMs, middle: { x: 700, y: 450 } };
      }),
      subject(TIMELINE, master, () => openTimeline(browser, master, recording)),
    ];
  },
};

interface OpenTimeline {
  readonly canvas: CanvasPage;
  readonly openMs: number;
  readonly readMs: number;
  readonly middle: Point;
}

function subject(name: string, master: MasterProcess, open: () => Promise<OpenTimeline>): Subject {
  return {
    name,
    pids: [],
    measure: (options) => measureTimeline(name, master.pid, open, options),
  };
}

async function openTimeline(
  browser: CanvasBrowser,
  { url }: MasterProcess,
  { path }: LongRecording,
): Promise<OpenTimeline> {
  const canvas = await browser.open(`${url}/recordings`);
  const { page } = canvas;
  const input = page.locator('input[type=file]').first();
  await input.waitFor({ state: 'attached' });
  const beganMs = performance.now();
  await input.setInputFiles(path);
  const tracks = page.getByRole('group', { name: 'Tracks' });
  await tracks.waitFor({ timeout: OPEN_TIMEOUT_MS });
  const openMs = performance.now() - beganMs;
  await page.getByText(/^Reading \d+ %$/).waitFor({ state: 'hidden', timeout: OPEN_TIMEOUT_MS });
  const readMs = performance.now() - beganMs;
  const box = (await tracks.boundingBox())!;
  return { canvas, openMs, readMs, middle: { x: box.x + box.width * 0.6, y: box.y + 120 } };
}

async function measureTimeline(
  name: string,
  masterPid: number,
  open: () => Promise<OpenTimeline>,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const { canvas, openMs, readMs, middle } = await open();
  const stopLap = startLap(() => descendantPids(process.pid));
  const figures: Record<string, number> = { openMs, readMs };
  const faults: string[] = [];
  let frames = 0;
  try {
    await sleep(SETTLE_MS);
    for (const gesture of TIMELINE_GESTURES) {
      await sleep(warmUpMs);
      const forMs = LENGTH_FACTOR * measureMs;
      const measured = await measureGesture(canvas, middle, gesture, masterPid, forMs);
      frames += measured.frames;
      Object.assign(figures, measured.figures);
      if (name === TIMELINE && !measured.hasChanged)
        faults.push(`${gesture.label}: nothing changed`);
    }
    const { otherCpuShare } = stopLap();
    return { figures, faults, deliveries: frames, otherCpuShare };
  } finally {
    await canvas.close();
  }
}

async function measureGesture(
  canvas: CanvasPage,
  middle: Point,
  { key, perform }: TimelineGesture,
  masterPid: number,
  forMs: number,
) {
  const before = await canvas.page.locator('body').innerText();
  const stopCpu = startBrowserCpu([masterPid]);
  await canvas.watch('start');
  await perform(canvas, middle, forMs);
  const intervals = (await canvas.watch('stop')).sort((a, b) => a - b);
  const { mainMs } = stopCpu();
  return {
    frames: intervals.length,
    hasChanged: (await canvas.page.locator('body').innerText()) !== before,
    figures: {
      [`${key}P50Ms`]: roundMs(percentile(intervals, 0.5)),
      [`${key}P95Ms`]: roundMs(percentile(intervals, 0.95)),
      [`${key}MainMs`]: mainMs / intervals.length,
    },
  };
}

/** Browsers tell the times of frames in steps of 0.1 ms. */
const roundMs = (ms: number): number => Math.round(ms * 10) / 10;
