import { setTimeout as sleep } from 'node:timers/promises';

import { MasterProcess } from '@ubii/harness';

import { startBrowserCpu, IN_CHROMIUM } from '../browser/chromium.ts';
import { descendantPids } from '../cpu-time.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type {
  FigureInfo,
  Measurement,
  MeasureOptions,
  Subject,
  Workload,
} from '../measuring/workload.ts';
import type { Part } from '../parts/shared-parts.ts';
import { percentile } from '../statistics.ts';
import { serveBareList, startListBrowser, type ListBrowser, type ListPage } from './topics-page.ts';

/** Frames are rarer than what other workloads measure. */
const LENGTH_FACTOR = 5;
/** Less than this share of the records: the figures would be of another load. */
const MIN_RATE = 0.9;

/** Load of a page with a list while it is measured. */
interface ListLoad {
  /** Records published so far. */
  readonly published: number;
  readonly updatesHz: number;
  /** Settles once everything is on the page. */
  whenThere(list: ListPage): Promise<void>;
}

/** The figures of a list, with the bounds of `subject`. */
function listFigures(subject: string, opened: string): readonly FigureInfo[] {
  const figure = (key: string, label: string, unit: string, bound?: number): FigureInfo => {
    const bounds: Record<string, number> = bound === undefined ? {} : { [subject]: bound };
    return { key, label, unit, isHigherBetter: false, goals: {}, bounds };
  };
  return [
    figure('openMs', opened, 'ms'),
    figure('liveP50Ms', 'looked at, frame p50', 'ms'),
    figure('liveP95Ms', 'looked at, frame p95', 'ms', 33),
    figure('liveMainMs', 'looked at, main thread a second', 'ms'),
    figure('scrollP50Ms', 'scrolled, frame p50', 'ms'),
    figure('scrollP95Ms', 'scrolled, frame p95', 'ms', 33),
    figure('scrollMainMs', 'scrolled, main thread a second', 'ms'),
    figure('heapMb', 'heap at the end', 'MB'),
    figure('heapGrowthMb', 'heap grown a minute', 'MB'),
  ];
}

function listSubject(name: string, measure: Subject['measure']): Subject {
  return { name, pids: [], measure };
}

/** Opens a page with a list, looks at it and scrolls it. */
async function measureList(
  browser: ListBrowser,
  url: string,
  load: ListLoad | undefined,
  masterPid: number,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const openedMs = performance.now();
  const list = await browser.open(url);
  try {
    await load?.whenThere(list);
    const openMs = performance.now() - openedMs;
    await sleep(warmUpMs);
    // The browser and the master are all that this process has started.
    const stopLap = startLap(() => descendantPids(process.pid));
    const heapBefore = await list.heapBytes();
    const beganMs = performance.now();
    const publishedBefore = load?.published ?? 0;
    const rowsBefore = await list.rows();
    const forMs = LENGTH_FACTOR * measureMs;
    const live = await measureFrames(list, masterPid, () => sleep(forMs));
    const rowsAfter = await list.rows();
    const seconds = (performance.now() - beganMs) / 1000;
    const published = (load?.published ?? 0) - publishedBefore;
    const scrolled = await measureFrames(list, masterPid, () => list.scroll(forMs));
    const heapMb = (await list.heapBytes()) / 1e6;
    const minutes = (performance.now() - beganMs) / 60_000;
    const { otherCpuShare } = stopLap();
    return {
      figures: {
        openMs,
        liveP50Ms: live.p50Ms,
        liveP95Ms: live.p95Ms,
        liveMainMs: live.mainMs,
        scrollP50Ms: scrolled.p50Ms,
        scrollP95Ms: scrolled.p95Ms,
        scrollMainMs: scrolled.mainMs,
        heapMb,
        heapGrowthMb: (heapMb - heapBefore / 1e6) / minutes,
      },
      deliveries: live.frames + scrolled.frames,
      otherCpuShare,
      faults: [
        ...(rowsBefore === rowsAfter ? ['no row changed while it was looked at'] : []),
        ...(load !== undefined && published < MIN_RATE * load.updatesHz * seconds
          ? [`only ${Math.round(published / seconds)} records a second were published`]
          : []),
      ],
    };
  } finally {
    await list.close();
  }
}

async function measureFrames(list: ListPage, masterPid: number, during: () => Promise<void>) {
  const stopCpu = startBrowserCpu([masterPid]);
  const beganMs = performance.now();
  const intervals = (await list.frames(during)).sort((a, b) => a - b);
  const seconds = (performance.now() - beganMs) / 1000;
  return {
    frames: intervals.length,
    p50Ms: roundMs(percentile(intervals, 0.5)),
    p95Ms: roundMs(percentile(intervals, 0.95)),
    mainMs: stopCpu().mainMs / seconds,
  };
}

/** Browsers tell the times of frames in steps of 0.1 ms. */
const roundMs = (ms: number): number => Math.round(ms * 10) / 10;

const REFERENCE = 'bare list';

/** A page of the master with a long list, and what fills it. */
interface ListPagePlan {
  /** Of the workload; without `-page` it is also the path of the page. */
  readonly name: 'clients-page' | 'topics-page';
  readonly title: string;
  /** Label of the figure for opening the page. */
  readonly opened: string;
  readonly updatesHz: number;
  fill(url: string): Promise<Part & { readonly published: number }>;
  /** Settles once everything is on the page. */
  whenThere(list: ListPage): Promise<void>;
}

/** A page with a long list, seen and scrolled, beside a plain list of numbers. */
export function listPageWorkload(plan: ListPagePlan): Workload {
  const { name, title, opened, updatesHz, fill, whenThere } = plan;
  const what = name.replace('-page', '');
  const subject = `${what} page`;
  return {
    name,
    group: name,
    title,
    figures: listFigures(subject, opened),
    reference: REFERENCE,
    ...IN_CHROMIUM,
    open: async ({ parts, master: file, profileDir }) => {
      const master = await parts.get('master', () =>
        MasterProcess.start({ program: file, profileDir }),
      );
      const content = await parts.get(what, () => fill(master.url));
      const browser = await parts.get('browser', startListBrowser);
      const bare = await parts.get('bare list', serveBareList);
      const url = `${master.url.replace(/\/$/, '')}/${what}`;
      const load = {
        get published() {
          return content.published;
        },
        updatesHz,
        whenThere,
      };
      return [
        listSubject(REFERENCE, (options) =>
          measureList(browser, bare.url, undefined, master.pid, options),
        ),
        listSubject(subject, (options) => measureList(browser, url, load, master.pid, options)),
      ];
    },
  };
}
