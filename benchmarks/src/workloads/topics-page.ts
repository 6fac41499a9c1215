import { setTimeout as sleep } from 'node:timers/promises';
import { startMasterProcess } from '../brokers/master-process.ts';
import { findChromium } from '../browser/chromium.ts';
import { descendantPids } from '../cpu-time.ts';
import { startBrowserCpu } from '../graph/browser-cpu.ts';
import { percentile } from '../statistics.ts';
import { publishManyTopics, TOPICS, UPDATES_HZ, type ManyTopics } from '../topics/many-topics.ts';
import {
  serveBareList,
  startListBrowser,
  type ListBrowser,
  type ListPage,
} from '../topics/topics-page.ts';
import { startLap } from './stopwatch.ts';
import type { FigureInfo, Measurement, MeasureOptions, Subject, Workload } from './workload.ts';

const REFERENCE = 'bare list';
const SUBJECT = 'topics page';
/** Frames are rarer than what other workloads measure. */
const LENGTH_FACTOR = 5;
const OPEN_TIMEOUT_MS = 60_000;
/** Less than this share of the records: the figures would be of another load. */
const MIN_RATE = 0.9;

function figure(key: string, label: string, unit: string, bound?: number): FigureInfo {
  const bounds: Record<string, number> = bound === undefined ? {} : { [SUBJECT]: bound };
  return { key, label, unit, isHigherBetter: false, goals: {}, bounds };
}

/** The topics page with very many topics, seen and scrolled, beside a plain list of numbers. */
export const topicsPage: Workload = {
  name: 'topics-page',
  group: 'topics-page',
  title: `Topics page: ${TOPICS} topics, ${UPDATES_HZ} updates/s`,
  figures: [
    figure('openMs', 'opened, all topics there', 'ms'),
    figure('liveP50Ms', 'looked at, frame p50', 'ms'),
    figure('liveP95Ms', 'looked at, frame p95', 'ms', 33),
    figure('liveMainMs', 'looked at, main thread a second', 'ms'),
    figure('scrollP50Ms', 'scrolled, frame p50', 'ms'),
    figure('scrollP95Ms', 'scrolled, frame p95', 'ms', 33),
    figure('scrollMainMs', 'scrolled, main thread a second', 'ms'),
    figure('heapMb', 'heap at the end', 'MB'),
    figure('heapGrowthMb', 'heap grown a minute', 'MB'),
  ],
  reference: REFERENCE,
  // The browser has many threads of its own.
  placement: 'anywhere',
  roundShare: 1 / 5,
  whyNot: () =>
    findChromium() === undefined
      ? 'there is no Chromium; install one, or name it in UBII_CHROMIUM'
      : undefined,
  open: async ({ parts, master: file, profileDir }) => {
    const master = await parts.get('master', () =>
      startMasterProcess({ master: file, profileDir }),
    );
    const topics = await parts.get('topics', () => publishManyTopics(master.url));
    const browser = await parts.get('browser', startListBrowser);
    const bare = await parts.get('bare list', serveBareList);
    const url = `${master.url.replace(/\/$/, '')}/topics`;
    return [
      subject(REFERENCE, (options) =>
        measureList(browser, bare.url, undefined, master.pid, options),
      ),
      subject(SUBJECT, (options) => measureList(browser, url, topics, master.pid, options)),
    ];
  },
};

function subject(name: string, measure: Subject['measure']): Subject {
  return { name, pids: [], measure };
}

async function measureList(
  browser: ListBrowser,
  url: string,
  topics: ManyTopics | undefined,
  masterPid: number,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const openedMs = performance.now();
  const list = await browser.open(url);
  try {
    if (topics !== undefined) await allTopicsThere(list);
    const openMs = performance.now() - openedMs;
    await sleep(warmUpMs);
    // The browser and the master are all that this process has started.
    const stopLap = startLap(() => descendantPids(process.pid));
    const heapBefore = await list.heapBytes();
    const beganMs = performance.now();
    const publishedBefore = topics?.published ?? 0;
    const rowsBefore = await list.rows();
    const forMs = LENGTH_FACTOR * measureMs;
    const live = await measureFrames(list, masterPid, () => sleep(forMs));
    const rowsAfter = await list.rows();
    const seconds = (performance.now() - beganMs) / 1000;
    const published = (topics?.published ?? 0) - publishedBefore;
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
        ...(topics !== undefined && published < MIN_RATE * UPDATES_HZ * seconds
          ? [`only ${Math.round(published / seconds)} records a second were published`]
          : []),
      ],
    };
  } finally {
    await list.close();
  }
}

/** Everything unfolded: as many rows as there can be. */
async function allTopicsThere({ page }: ListPage): Promise<void> {
  // The master has some of its own, too
  const count = page.getByText(new RegExp(`^${TOPICS / 1000}\\s?0\\d\\d$`)).first();
  await count.waitFor({ timeout: OPEN_TIMEOUT_MS });
  await page.getByRole('button', { name: 'Order and folding' }).click();
  await page.getByRole('menuitem', { name: 'Expand all' }).click();
  await page
    .getByRole('row', { name: /value-0/ })
    .first()
    .waitFor();
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
