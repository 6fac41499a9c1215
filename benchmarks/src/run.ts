import type { Broker, Target, TargetName } from './brokers/target.ts';
import { startRawWs } from './brokers/raw-ws.ts';
import { BUILT_MASTER, startUbii } from './brokers/ubii.ts';
import { placeProcesses } from './cpu-placement.ts';
import type { RunOptions } from './options.ts';
import { Patience } from './quiet-machine.ts';
import type { WorkloadResult } from './report/results.ts';
import type { Measurement, Workload } from './workloads/workload.ts';

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
  const brokers: Broker[] = [];
  const patience = new Patience(options.waitMs, say);
  try {
    brokers.push(await startRawWs(options.profileDir));
    brokers.push(await startUbii(options.master ?? BUILT_MASTER, options.profileDir));
    const targets = brokers.flatMap((broker) => broker.targets);
    const prepared = workloads.map((workload) => ({
      workload,
      ring: workload.createRing(),
      rounds: Object.fromEntries(targets.map(({ name }) => [name, []])) as unknown as Record<
        TargetName,
        Measurement[]
      >,
    }));
    for (let round = 0; round < options.rounds; round += 1) {
      for (const { workload, ring, rounds } of prepared) {
        for (const target of rotated(targets, round)) {
          await patience.waitForQuiet();
          placeProcesses(workload.placement, [process.pid, target.pid]);
          const measurement = await workload.measure(target, ring, options);
          rounds[target.name].push(measurement);
          say(progressLine(round, options.rounds, workload, target, measurement));
        }
      }
    }
    return prepared.map(({ workload: { name, title, figures }, rounds }) => ({
      name,
      title,
      figures,
      rounds,
    }));
  } finally {
    await Promise.all(brokers.map((broker) => broker.stop()));
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
