import { setTimeout as sleep } from 'node:timers/promises';

import { BUILT_MASTER } from '@ubii/harness';

import { placeProcesses } from './cpu-placement.ts';
import { machineCpuUs } from './cpu-time.ts';
import type { Measurement, Subject, Workload } from './measuring/workload.ts';
import type { RunOptions } from './options.ts';
import { SharedParts } from './parts/shared-parts.ts';
import type { WorkloadResult } from './report/results.ts';

const SAMPLE_MS = 300;
/** Cores that may be in use, by everything on the machine, for it to count as quiet. */
const QUIET_SHARE = 0.15;

/** Time that may be spent waiting for other processes, for a whole run. */
class Patience {
  #leftMs: number;
  readonly #say: (line: string) => void;

  constructor(forMs: number, say: (line: string) => void) {
    this.#leftMs = forMs;
    this.#say = say;
  }

  /** Resolves when little else is running, or after a timeout. */
  async waitForQuiet(): Promise<void> {
    let hasSaid = false;
    while (this.#leftMs > 0) {
      const startMs = performance.now();
      const startUs = machineCpuUs();
      await sleep(SAMPLE_MS);
      const tookMs = performance.now() - startMs;
      const share = (machineCpuUs() - startUs) / 1000 / tookMs;
      if (share <= QUIET_SHARE) return;
      this.#leftMs -= tookMs;
      if (!hasSaid) this.#say(`waiting: other processes use ${share.toFixed(1)} cores`);
      hasSaid = true;
    }
  }
}

/** Rounds after which everything is started again: two starts of one program differ by some per cent. */
const ROUNDS_PER_START = 5;
/** Fewer have no median worth the name. */
const MIN_ROUNDS = 3;

type Rounds = Record<string, Measurement[]>;

/** A workload with what it measured so far. */
interface Measured {
  readonly workload: Workload;
  readonly roundCount: number;
  readonly rounds: Rounds;
}

/**
 * Measures the workloads, group after group. Every round has one measurement of every subject, so
 * a disturbance of the machine affects all.
 *
 * @param say called with one line about each step
 */
export async function runWorkloads(
  workloads: readonly Workload[],
  options: RunOptions,
  say: (line: string) => void,
): Promise<WorkloadResult[]> {
  const patience = new Patience(options.waitMs, say);
  const all = workloads.map((workload) => ({
    workload,
    roundCount: Math.max(MIN_ROUNDS, Math.round(options.rounds * workload.roundShare)),
    rounds: {},
  }));
  for (const group of new Set(workloads.map((workload) => workload.group))) {
    const members = all.filter(({ workload }) => workload.group === group);
    await measureGroup(members, options, patience, say);
  }
  return all.map(({ workload: { name, title, figures, reference }, rounds }) => ({
    name,
    title,
    figures,
    reference,
    rounds,
  }));
}

async function measureGroup(
  members: readonly Measured[],
  options: RunOptions,
  patience: Patience,
  say: (line: string) => void,
): Promise<void> {
  const most = Math.max(...members.map(({ roundCount }) => roundCount));
  for (let first = 0; first < most; first += ROUNDS_PER_START) {
    const parts = new SharedParts();
    // Resets the own placement, so that started processes do not inherit it.
    placeProcesses('anywhere', process.pid, []);
    try {
      const setting = {
        parts,
        master: options.master ?? BUILT_MASTER,
        profileDir: options.profileDir,
      };
      const opened = new Map<Measured, readonly Subject[]>();
      for (const member of members) {
        if (first < member.roundCount) opened.set(member, await member.workload.open(setting));
      }
      for (let round = first; round < Math.min(first + ROUNDS_PER_START, most); round += 1) {
        for (const [member, subjects] of opened) {
          if (round >= member.roundCount) continue;
          await measureRound(round, member, rotated(subjects, round), options, patience, say);
        }
      }
    } finally {
      await parts.stop();
    }
  }
}

async function measureRound(
  round: number,
  { workload, roundCount, rounds }: Measured,
  subjects: readonly Subject[],
  options: RunOptions,
  patience: Patience,
  say: (line: string) => void,
): Promise<void> {
  const measured: Record<string, Measurement> = {};
  for (const subject of subjects) {
    await patience.waitForQuiet();
    placeProcesses(workload.placement, process.pid, subject.pids);
    const measurement = await measureOrFail(subject, options);
    measured[subject.name] = measurement;
    say(
      `round ${round + 1}/${roundCount}  ${workload.name}  ${describe(workload, subject, measurement)}`,
    );
  }
  Object.assign(measured, workload.derive?.(measured));
  for (const [name, measurement] of Object.entries(measured)) {
    (rounds[name] ??= []).push(measurement);
  }
}

/** A failed measurement is a fault of this round; the others continue. */
async function measureOrFail(subject: Subject, options: RunOptions): Promise<Measurement> {
  try {
    return await subject.measure(options);
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return { figures: {}, deliveries: 0, otherCpuShare: 0, faults: [reason] };
  }
}

/** The subjects, each round beginning with another one: no subject always follows the same neighbour. */
function rotated(subjects: readonly Subject[], round: number): Subject[] {
  const first = round % subjects.length;
  return [...subjects.slice(first), ...subjects.slice(0, first)];
}

function describe(workload: Workload, subject: Subject, measurement: Measurement): string {
  const figures = workload.figures.flatMap(({ key, label, unit }) => {
    const value = measurement.figures[key];
    return value === undefined ? [] : [`${label} ${value.toPrecision(4)} ${unit}`];
  });
  const faults = measurement.faults.length > 0 ? ` (${measurement.faults.join('; ')})` : '';
  return `${subject.name}: ${figures.join(', ')}${faults}`;
}
