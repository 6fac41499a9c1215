import { setTimeout as sleep } from 'node:timers/promises';
import { descendantPids } from '../cpu-time.ts';
import { startBrowserCpu, IN_CHROMIUM } from '../browser/chromium.ts';
import type { CanvasPage } from '../graph/canvas-page.ts';
import { GESTURES, zoomIn, type Gesture } from '../graph/gestures.ts';
import {
  EDITOR,
  openGraphSubjects,
  REFERENCE,
  type GraphSubject,
  type OpenGraph,
} from '../graph/graph-subjects.ts';
import { percentile } from '../statistics.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type {
  FigureInfo,
  Measurement,
  MeasureOptions,
  Subject,
  Workload,
} from '../measuring/workload.ts';

const MODULES = 200;
/** A gesture takes longer than what other workloads measure at a time. */
const LENGTH_FACTOR = 5;
/** The shortest accepted movement by a gesture, pixels of the page. */
const MIN_MOVE_PX = 20;
const MIN_ZOOM_FACTOR = 1.2;
/** Two frames of a screen with 60 Hz, in the steps in which browsers tell times, milliseconds. */
const TWO_FRAMES_MS = 33.4;
/** In which what came near is made, or what was on its way to a page that is hidden arrives. */
const SETTLE_MS = 1000;
/** Values that must have changed of those that were seen: all do several times a second. */
const MIN_CHANGED = 0.9;

function figure(key: string, label: string, unit: string, bound?: number): FigureInfo {
  const bounds: Record<string, number> = bound === undefined ? {} : { [EDITOR]: bound };
  return { key, label, unit, isHigherBetter: false, goals: {}, bounds };
}

/** A running session as a graph, seen and moved with the mouse, beside plain boxes and lines. */
export const graphEditor: Workload = {
  name: 'graph-editor',
  group: 'graph-editor',
  title: `Graph editor: ${MODULES} modules, ${2 * MODULES} wires, 1000 records/s`,
  figures: [
    ...GESTURES.flatMap(({ key, label }) => [
      figure(`${key}P50Ms`, `${label}, frame p50`, 'ms', 16.7),
      figure(`${key}P95Ms`, `${label}, frame p95`, 'ms', TWO_FRAMES_MS),
      figure(`${key}MainMs`, `${label}, main thread a frame`, 'ms'),
      figure(`${key}OtherMs`, `${label}, other threads a frame`, 'ms'),
    ]),
    figure('hiddenMainMs', 'hidden, main thread a second', 'ms'),
    figure('hiddenFrames', 'hidden, messages a second', '/s', 2),
    figure('hiddenChanges', 'hidden, changes drawn a second', '/s', 0),
  ],
  reference: REFERENCE,
  ...IN_CHROMIUM,
  open: async (setting) => {
    const size = { modules: MODULES, showsTopics: false, isRunning: true };
    const { subjects, master } = await openGraphSubjects(setting, size);
    return subjects.map((subject): Subject => ({
      name: subject.name,
      pids: [],
      measure: (options) => measureGraph(subject, master.pid, options),
    }));
  },
};

/** The largest session that a master takes, with a node for each topic: from navigation until it is drawn. */
export const graphEditorOpen: Workload = {
  name: 'graph-editor-open',
  group: 'graph-editor',
  title: 'Graph editor: opening a session of 500 nodes and 740 wires',
  figures: [
    figure('openMs', 'until all nodes are drawn', 'ms', 3000),
    figure('mainMs', 'main thread until then', 'ms'),
  ],
  reference: REFERENCE,
  ...IN_CHROMIUM,
  open: async (setting) => {
    const size = { modules: 250, showsTopics: true, isRunning: false };
    const { subjects, master } = await openGraphSubjects(setting, size);
    return subjects.map((subject): Subject => ({
      name: subject.name,
      pids: [],
      measure: () => measureOpening(subject, master.pid),
    }));
  },
};

async function measureOpening(subject: GraphSubject, masterPid: number): Promise<Measurement> {
  const stopLap = startLap(() => descendantPids(process.pid));
  const stopCpu = startBrowserCpu([masterPid]);
  const { canvas, openMs } = await subject.open();
  const { mainMs } = stopCpu();
  const { otherCpuShare } = stopLap();
  await canvas.close();
  return { figures: { openMs, mainMs }, faults: [], deliveries: subject.nodeCount, otherCpuShare };
}

async function measureGraph(
  subject: GraphSubject,
  masterPid: number,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const graph = await subject.open();
  // The browser and the master are all that this process has started.
  const stopLap = startLap(() => descendantPids(process.pid));
  const figures: Record<string, number> = {};
  const faults: string[] = [];
  let frames = 0;
  try {
    for (const gesture of GESTURES) {
      const { zoom } = gesture;
      if (zoom !== undefined) {
        await zoomIn(graph.canvas, graph.middle, zoom);
        await sleep(SETTLE_MS);
      }
      await sleep(warmUpMs);
      const isLive = subject.name === EDITOR && zoom !== undefined;
      if (isLive) await graph.canvas.watch('noteValues');
      const measured = await measureGesture(graph, gesture, masterPid, LENGTH_FACTOR * measureMs);
      frames += measured.frames;
      Object.assign(figures, measured.figures);
      faults.push(...measured.faults);
      if (isLive) faults.push(...stillValues(await graph.canvas.watch('changedValues')));
    }
    Object.assign(figures, await measureHidden(graph.canvas, masterPid, measureMs));
    const { otherCpuShare } = stopLap();
    return { figures, faults, deliveries: frames, otherCpuShare };
  } finally {
    await graph.canvas.close();
  }
}

async function measureGesture(
  { canvas, middle }: OpenGraph,
  { key, label, perform }: Gesture,
  masterPid: number,
  forMs: number,
) {
  const node = await canvas.watch('nodeNear', middle.x, middle.y);
  const begin = await canvas.watch('place', node);
  const stopCpu = startBrowserCpu([masterPid]);
  await canvas.watch('start');
  let on = begin;
  await perform(canvas, middle, forMs, async () => {
    on = await canvas.watch('place', node);
  });
  const intervals = (await canvas.watch('stop')).sort((a, b) => a - b);
  const { mainMs, otherMs } = stopCpu();
  const hasMoved =
    Math.hypot(on.x - begin.x, on.y - begin.y) >= MIN_MOVE_PX ||
    Math.max(on.scale / begin.scale, begin.scale / on.scale) >= MIN_ZOOM_FACTOR;
  return {
    frames: intervals.length,
    figures: {
      [`${key}P50Ms`]: roundMs(percentile(intervals, 0.5)),
      [`${key}P95Ms`]: roundMs(percentile(intervals, 0.95)),
      [`${key}MainMs`]: mainMs / intervals.length,
      [`${key}OtherMs`]: otherMs / intervals.length,
    },
    faults: hasMoved ? [] : [`${label}: nothing moved`],
  };
}

/** Browsers tell the times of frames in steps of 0.1 ms. */
const roundMs = (ms: number): number => Math.round(ms * 10) / 10;

function stillValues({ seen, changed }: { seen: number; changed: number }): string[] {
  if (seen > 0 && changed >= MIN_CHANGED * seen) return [];
  return [`of ${seen} values that are seen, ${changed} changed`];
}

async function measureHidden(canvas: CanvasPage, masterPid: number, forMs: number) {
  const session = await canvas.page.context().newCDPSession(canvas.page);
  let messages = 0;
  session.on('Network.webSocketFrameReceived', () => (messages += 1));
  await canvas.watch('hide');
  await sleep(SETTLE_MS);
  await canvas.watch('settled');
  await session.send('Network.enable');
  const stopCpu = startBrowserCpu([masterPid]);
  const seconds = (LENGTH_FACTOR * forMs) / 1000;
  messages = 0;
  await sleep(1000 * seconds);
  const { mainMs } = stopCpu();
  const changes = await canvas.watch('show');
  await session.detach();
  return {
    hiddenMainMs: mainMs / seconds,
    hiddenFrames: messages / seconds,
    hiddenChanges: changes / seconds,
  };
}
