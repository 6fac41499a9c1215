import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

import type { MasterProcess } from '@ubii/harness';

import { pause } from '../pause.ts';

/** Tolerated increase of a quantity: the larger of the two. */
interface Tolerance {
  /** Share of the value after warm-up. */
  readonly relative: number;
  readonly absolute: number;
}

/** Course of a quantity from the end of the warm-up to the end of the run. */
export interface Growth {
  /** Medians of the four quarters of the samples, in their order. */
  readonly quarters: readonly [number, number, number, number];
  /** Difference between the last quarter and the first. */
  readonly more: number;
  /** The tolerated difference. */
  readonly tolerated: number;
  /** Every quarter is above the one before, whatever the amount. */
  readonly isRising: boolean;
  /** The last quarter is above the first by more than is tolerated. */
  readonly isGrown: boolean;
}

/**
 * Compares the quarters of a series, by their medians: single peaks, such as a collection of garbage that was late,
 * count for nothing.
 *
 * @throws Error for fewer than eight samples
 */
export function judgeGrowth(series: readonly number[], tolerance: Tolerance): Growth {
  if (series.length < 8) throw new Error('Growth takes eight samples at least.');
  const at = (quarter: number): number => Math.round((series.length * quarter) / 4);
  const medianOf = (quarter: number): number => median(series.slice(at(quarter), at(quarter + 1)));
  const quarters = [medianOf(0), medianOf(1), medianOf(2), medianOf(3)] as const;
  const more = quarters[3] - quarters[0];
  const tolerated = Math.max(tolerance.absolute, tolerance.relative * quarters[0]);
  return {
    quarters,
    more,
    tolerated,
    isRising: quarters.every((value, index) => index === 0 || value > quarters[index - 1]!),
    isGrown: more > tolerated,
  };
}

/** @throws Error for an empty list */
export function median(values: readonly number[]): number {
  if (values.length === 0) throw new Error('Nothing has no median.');
  const sorted = values.toSorted((a, b) => a - b);
  const middle = sorted.length >> 1;
  return sorted.length % 2 === 1 ? sorted[middle]! : (sorted[middle - 1]! + sorted[middle]!) / 2;
}

const TIMEOUT_MS = 60_000;

/**
 * The measured quantities with their tolerated increase: the larger of a share and an amount. At rest, counts have the
 * amount alone, because no client comes or goes then.
 */
export const QUANTITIES = {
  heapBytes: { title: 'heap after collection', isBytes: true, relative: 0.1, absolute: 6 << 20 },
  externalBytes: { title: 'buffers', isBytes: true, relative: 0.1, absolute: 8 << 20 },
  residentBytes: { title: 'resident memory', isBytes: true, relative: 0.1, absolute: 48 << 20 },
  descriptors: { title: 'descriptors', isBytes: false, relative: 0.25, absolute: 8 },
  files: { title: 'files of recordings', isBytes: false, relative: 0, absolute: 4 },
  threads: { title: 'threads', isBytes: false, relative: 0, absolute: 2 },
  timers: { title: 'timers', isBytes: false, relative: 0.25, absolute: 8 },
  handles: { title: 'other resources of Node', isBytes: false, relative: 0.25, absolute: 8 },
  topics: { title: 'topics', isBytes: false, relative: 0.25, absolute: 32 },
  retainedBytes: { title: 'retained records', isBytes: true, relative: 0.05, absolute: 64 << 10 },
  clients: { title: 'clients', isBytes: false, relative: 0.1, absolute: 8 },
  devices: { title: 'devices', isBytes: false, relative: 0, absolute: 8 },
  sessions: { title: 'sessions', isBytes: false, relative: 0, absolute: 2 },
} as const;

export type Quantity = keyof typeof QUANTITIES;
export type Sample = Readonly<Record<Quantity, number>>;

/** Measures a master that was started with `probeFlags`. */
export class Gauge {
  readonly #master: MasterProcess;
  readonly #file: string;
  #count = 0;

  constructor(master: MasterProcess, file: string) {
    this.#master = master;
    this.#file = file;
  }

  /** @throws Error when the probe writes nothing for a minute */
  async read(): Promise<Sample> {
    process.kill(this.#master.pid, 'SIGUSR2');
    this.#count++;
    const report = await this.#readProbe();
    const figures = this.#master.figures();
    const metrics = await this.#master.metrics();
    const sum = (name: string): number => {
      let all = 0;
      for (const [key, value] of metrics) {
        if (key === name || key.startsWith(`${name}{`)) all += value;
      }
      return all;
    };
    const { Timeout: timers = 0, ...others } = report.resources;
    // These are about what is under way at the moment.
    for (const passing of ['Immediate', 'TickObject', 'FSReqPromise', 'FSReqCallback']) {
      delete (others as Record<string, number>)[passing];
    }
    return {
      heapBytes: report.heapUsed,
      externalBytes: report.external,
      residentBytes: figures.residentBytes ?? 0,
      descriptors: figures.descriptors ?? 0,
      files: filesIn(join(this.#master.dataDir, 'recordings')),
      threads: figures.threads ?? 0,
      timers,
      handles: Object.values(others).reduce((all, one) => all + one, 0),
      topics: sum('ubii_topics'),
      retainedBytes: sum('ubii_retained_bytes'),
      clients: sum('ubii_clients'),
      devices: sum('ubii_devices'),
      sessions: sum('ubii_sessions'),
    };
  }

  async #readProbe(): Promise<ProbeReport> {
    const endMs = performance.now() + TIMEOUT_MS;
    while (performance.now() < endMs) {
      try {
        const report = JSON.parse(readFileSync(this.#file, 'utf8')) as ProbeReport;
        if (report.count >= this.#count) return report;
      } catch {
        // Not written yet.
      }
      await pause(20);
    }
    throw new Error('The probe in the master wrote no report.');
  }
}

function filesIn(folder: string): number {
  return existsSync(folder) ? readdirSync(folder).length : 0;
}

interface ProbeReport {
  readonly count: number;
  readonly heapUsed: number;
  readonly external: number;
  readonly resources: Readonly<Record<string, number>>;
}

/** Flags of Node that load the probe, which writes what the process holds to a file. */
export function probeFlags(file: string): string[] {
  const probe = new URL('probe.mjs', import.meta.url);
  probe.search = encodeURIComponent(file);
  return ['--expose-gc', '--import', probe.href];
}
