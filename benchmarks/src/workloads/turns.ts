import { existsSync, readFileSync, mkdtempSync, rmSync } from 'node:fs';
import { SourceMap } from 'node:module';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { tmpdir } from 'node:os';
import { setTimeout as sleep } from 'node:timers/promises';

import { startRawWs, startUbii } from '../brokers/brokers.ts';
import { REFERENCE, type Access, type Broker, type BrokerClient } from '../brokers/target.ts';
import { DeliveryVerifier } from '../load/delivery-verifier.ts';
import { createRecordRing } from '../load/record-ring.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Workload } from '../measuring/workload.ts';
import { PartyTraffic } from '../party/party-traffic.ts';
import { median } from '../statistics.ts';

/** A CPU profile, as far as it is read. Times are µs of the monotonic clock of the system. */
export interface CpuProfile {
  readonly startTime: number;
  readonly nodes: readonly ProfileNode[];
  readonly samples: readonly number[];
  readonly timeDeltas: readonly number[];
}

interface ProfileNode {
  readonly id: number;
  readonly callFrame: CallFrame;
  readonly children?: readonly number[];
}

interface CallFrame {
  readonly functionName: string;
  readonly url: string;
  /** From 0. */
  readonly lineNumber: number;
  readonly columnNumber: number;
}

/** Time for which a thread did one thing, without a look at its event loop in between. */
interface Turn {
  readonly ms: number;
  /** Functions that took most of it, from the entry down. */
  readonly names: readonly string[];
}

/** Nothing to do, and native code such as the wait for events. */
const OUTSIDE = new Set(['(idle)', '(program)']);
const ROOT = '(root)';
/** Frames of Node that say nothing of what was done. */
const NODE = /^node:/;
const MAX_NAMES = 4;
/** Where samples are further apart than this many times what is usual, the thread did not run: another one had its core. */
const MAX_INTERVALS = 2;
/** A function is named when it has at least this share of the turn. */
const NAMED_SHARE = 0.3;

/**
 * The turns of a profile, longest first. Callbacks that follow each other without a pause count as one as long as they come from the
 * same entry: reads of many sockets are one turn.
 *
 * @param fromUs,untilUs of the clock of the profile
 */
export function findTurns(profile: CpuProfile, fromUs: number, untilUs: number): Turn[] {
  const nodes = new Map(profile.nodes.map((node) => [node.id, node]));
  const parents = new Map<number, number>();
  for (const { id, children } of profile.nodes)
    for (const child of children ?? []) parents.set(child, id);
  const pathOf = (id: number): ProfileNode[] => {
    const path: ProfileNode[] = [];
    for (let at: number | undefined = id; at !== undefined; at = parents.get(at)) {
      const node = nodes.get(at)!;
      if (node.callFrame.functionName !== ROOT) path.unshift(node);
    }
    return path;
  };
  const paths = new Map<number, ProfileNode[]>();
  const turns: Turn[] = [];
  let open: { entry: string; us: number; byNode: Map<ProfileNode, number> } | undefined;
  const close = (): void => {
    if (open !== undefined)
      turns.push({ ms: open.us / 1000, names: namesOf(open.byNode, open.us) });
    open = undefined;
  };
  const mostUs = MAX_INTERVALS * median(profile.timeDeltas);
  let atUs = profile.startTime;
  profile.samples.forEach((id, index) => {
    const us = Math.min(profile.timeDeltas[index + 1] ?? 0, mostUs);
    atUs += profile.timeDeltas[index] ?? 0;
    if (atUs < fromUs || atUs > untilUs) return close();
    let path = paths.get(id);
    if (path === undefined) paths.set(id, (path = pathOf(id)));
    const entry = path[0]?.callFrame.functionName ?? '';
    if (entry === '' || OUTSIDE.has(entry)) return close();
    if (open?.entry !== entry) {
      close();
      open = { entry, us: 0, byNode: new Map() };
    }
    open!.us += us;
    for (const node of path) open!.byNode.set(node, (open!.byNode.get(node) ?? 0) + us);
  });
  close();
  return turns.sort((a, b) => b.ms - a.ms);
}

function namesOf(byNode: ReadonlyMap<ProfileNode, number>, us: number): string[] {
  const large = [...byNode].filter(([, each]) => each >= NAMED_SHARE * us).map(([node]) => node);
  const ours = large.filter(({ callFrame }) => !NODE.test(callFrame.url));
  const named = (ours.length > 0 ? ours : large).map(({ callFrame }) => nameOf(callFrame));
  return [...new Set(named)].slice(-MAX_NAMES);
}

const maps = new Map<string, SourceMap | undefined>();

/** With the place in the sources, where a map is beside the program. */
function nameOf({ functionName, url, lineNumber, columnNumber }: CallFrame): string {
  const name = functionName || '(anonymous)';
  if (!url.startsWith('file:')) return url === '' ? name : `${name} (${basename(url)})`;
  const found = mapOf(url)?.findEntry(lineNumber, columnNumber);
  if (found === undefined || !('originalSource' in found)) return `${name} (${basename(url)})`;
  return `${name} (${basename(found.originalSource)}:${found.originalLine + 1})`;
}

function mapOf(url: string): SourceMap | undefined {
  if (!maps.has(url)) {
    const file = `${fileURLToPath(url)}.map`;
    maps.set(
      url,
      existsSync(file) ? new SourceMap(JSON.parse(readFileSync(file, 'utf8'))) : undefined,
    );
  }
  return maps.get(url);
}

const OURS = 'ubii-extension';
/** Turns that are listed. */
const LISTED = 20;
/** Turns that hold other work up. */
const LONG_MS = 0.5;
/** A measurement is this many times as long as others: what is rare has to happen. */
const TIMES = 15;
/** Clients that stay beside the party, and those that come and leave each second. */
const IDLE_CLIENTS = 200;
const COMING_CLIENTS = 5;
const ring = createRecordRing('turns', 100, 1);

/** What holds the thread of a broker, from a CPU profile with a sample each 0.2 ms. */
export const turns: Workload = {
  name: 'turns',
  group: 'turns',
  title: 'Longest turns while a party plays, 200 clients are idle, and 5 a second come and leave',
  figures: [
    { key: 'longestMs', label: 'longest', unit: 'ms', isHigherBetter: false, goals: {} },
    { key: 'longPerS', label: 'over 0.5 ms', unit: '1/s', isHigherBetter: false, goals: {} },
    { key: 'heldPercent', label: 'time in those', unit: '%', isHigherBetter: false, goals: {} },
  ],
  placement: 'core-each',
  reference: REFERENCE,
  roundShare: 1 / 5,
  open: ({ master }) => {
    const subject = (
      name: string,
      start: (profileDir: string) => Promise<Broker>,
      file: string,
    ) => ({
      name,
      pids: [],
      measure: (options: MeasureOptions) => measureTurns(start, file, options),
    });
    return Promise.resolve([
      subject(REFERENCE, startRawWs, 'raw-ws'),
      subject(OURS, (profileDir) => startUbii(master, profileDir), 'ubii'),
    ]);
  },
};

async function measureTurns(
  start: (profileDir: string) => Promise<Broker>,
  file: string,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-turns-'));
  try {
    const broker = await start(folder);
    let span: readonly [number, number];
    let faults: string[];
    let records: number;
    let otherCpuShare: number;
    try {
      const access = broker.targets[0]!;
      const idle = await joinMany(access, IDLE_CLIENTS);
      const traffic = await PartyTraffic.open(access);
      traffic.play();
      await sleep(2000 + warmUpMs);
      const stopLap = startLap(access.pids);
      const fromUs = monotonicUs();
      const endMs = performance.now() + TIMES * measureMs;
      while (performance.now() < endMs) {
        const coming = await joinMany(access, COMING_CLIENTS);
        await sleep(1000);
        await Promise.all(coming.map((client) => client.leave()));
      }
      span = [fromUs, monotonicUs()];
      ({ otherCpuShare } = stopLap());
      ({ faults, records } = await traffic.end());
      await Promise.all(idle.map(({ connection }) => connection.close()));
    } finally {
      await broker.stop();
    }
    const text = readFileSync(join(folder, `${file}.cpuprofile`), 'utf8');
    const found = findTurns(JSON.parse(text) as CpuProfile, ...span);
    const long = found.filter(({ ms }) => ms > LONG_MS);
    const seconds = (span[1] - span[0]) / 1e6;
    return {
      figures: {
        longestMs: found[0]?.ms ?? 0,
        longPerS: long.length / seconds,
        heldPercent: long.reduce((sum, { ms }) => sum + ms, 0) / seconds / 10,
      },
      otherCpuShare,
      deliveries: records,
      faults,
      notes: found.slice(0, LISTED).map(describe),
    };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

function describe({ ms, names }: Turn): string {
  return `${ms.toFixed(2)} ms  ${names.join(' > ')}`;
}

/** The clock of CPU profiles. */
function monotonicUs(): number {
  return Number(process.hrtime.bigint() / 1000n);
}

function joinMany(access: Access, count: number): Promise<BrokerClient[]> {
  const role = {
    publishes: false,
    topics: [ring.topic],
    rooms: { publish: '', subscribe: 'idle' },
  };
  return Promise.all(
    Array.from({ length: count }, () => access.join(role, new DeliveryVerifier(ring))),
  );
}
