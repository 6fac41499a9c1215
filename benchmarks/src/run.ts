import type { Broker, Target, TargetName } from './brokers/target.ts';
import { startRawWs } from './brokers/raw-ws.ts';
import { BUILT_MASTER, startUbii } from './brokers/ubii.ts';
import { placeProcesses } from './cpu-placement.ts';
import type { RecordRing } from './load/record-ring.ts';
import type { RunOptions } from './options.ts';
import { Patience } from './quiet-machine.ts';
import type { WorkloadResult } from './report/results.ts';
import type { Measurement, Workload } from './workloads/workload.ts';

/** Rounds after which the brokers are started anew: two starts of one program differ by some per cent. */
const ROUNDS_PER_START = 5;

/** A workload with what it sends and what it measured so far. */
interface Prepared {
  readonly workload: Workload;
  readonly ring: RecordRing;
  readonly rounds: Partial<Record<TargetName, Measurement[]>>;
}

/**
 * Starts all brokers and measures them in turn: every round has one measurement of every target for
 * every workload, so what disturbs the machine for a while disturbs all of them.
 *
 * @param say called with one line about each step
 */
export async function runWorkloads(
  workloads: readonly Workload[],
  options: RunOptions,
  say: (line: string) => void,
): Promise<WorkloadResult[]> {
  const patience = new Patience(options.waitMs, say);
  const prepared = workloads.map((workload) => ({
    workload,
    ring: workload.createRing(),
    rounds: {},
  }));
  for (let first = 0; first < options.rounds; first += ROUNDS_PER_START) {
    const brokers: Broker[] = [];
    try {
      brokers.push(await startRawWs(options.profileDir));
      brokers.push(await startUbii(options.master ?? BUILT_MASTER, options.profileDir));
      const targets = brokers.flatMap((broker) => broker.targets);
      const end = Math.min(first + ROUNDS_PER_START, options.rounds);
      for (let round = first; round < end; round += 1) {
        await measureRound(round, prepared, rotated(targets, round), patience, options, say);
      }
    } finally {
      await Promise.all(brokers.map((broker) => broker.stop()));
    }
  }
  return prepared.map(({ workload: { name, title, figures }, rounds }) => ({
    name,
    title,
    figures,
    rounds: rounds as Record<TargetName, Measurement[]>,
  }));
}

async function measureRound(
  round: number,
  prepared: readonly Prepared[],
  targets: readonly Target[],
  patience: Patience,
  options: RunOptions,
  say: (line: string) => void,
): Promise<void> {
  for (const { workload, ring, rounds } of prepared) {
    for (const target of targets) {
      await patience.waitForQuiet();
      placeProcesses(workload.placement, process.pid, target.pid);
      const measurement = await workload.measure(target, ring, options);
      (rounds[target.name] ??= []).push(measurement);
      say(progressLine(round, options.rounds, workload, target, measurement));
    }
  }
}

/** The targets, each round beginning with another one: nobody always follows the same neighbour. */
function rotated(targets: readonly Target[], round: number): Target[] {
  const first = round % targets.length;
  return [...targets.slice(first), ...targets.slice(0, first)];
}

function progressLine(
  round: number,
  rounds: number,
  workload: Workload,
  target: Target,
  measurement: Measurement,
): string {
  const figures = workload.figures.map(
    ({ key, label, unit }) => `${label} ${measurement.figures[key]?.toPrecision(4)} ${unit}`,
  );
  const faults = measurement.faults.length > 0 ? ` (${measurement.faults.join('; ')})` : '';
  return `round ${round + 1}/${rounds}  ${workload.name}  ${target.name}: ${figures.join(', ')}${faults}`;
}
