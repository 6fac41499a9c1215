import { Random } from '../random.ts';
import { TestCluster } from './cluster.ts';
import type { Fault } from './faults.ts';
import type { ClusterNetwork } from './network/cluster-network.ts';
import { findAbsent, BackgroundWorkload, runPhase, type PhaseReport } from './phase.ts';
import { settle } from './agreement.ts';

const MASTERS = 3;
const TIMEOUT_MS = 300_000;

/** Parameters of a run. */
export interface RunPlan {
  readonly network: ClusterNetwork;
  /** Main file of a built master. */
  readonly program: string;
  readonly faults: readonly Fault[];
  readonly seed: number;
  /** Clients on the machine of each master. */
  readonly clients: number;
  /** Topics whose publishers are on the machine of each master. */
  readonly topics: number;
  /** Topics that each client subscribes to. */
  readonly topicsPerClient: number;
  /** Time between two records of a topic, milliseconds. */
  readonly periodMs: number;
  /** Whether this process may raise the number of descriptors of the masters. */
  readonly canOpenMore: boolean;
  readonly say: (text: string) => void;
}

/** Number of masters of a run. */
export const MASTER_COUNT = MASTERS;

/** Starts a cluster with its clients, and does one fault after the other. */
export async function runFaults(plan: RunPlan): Promise<readonly PhaseReport[]> {
  const { network, program, canOpenMore, faults, say } = plan;
  const cluster = await TestCluster.start(network, MASTERS, { program, canOpenMore });
  try {
    const tookMs = await joinAll(cluster, plan);
    say(`${MASTERS} × ${plan.clients} clients joined in ${(tookMs / 1000).toFixed(1)} s`);
    for (const figure of cluster.figures()) say(`  ${figure}`);
    const background = new BackgroundWorkload(cluster, new Random(plan.seed));
    const reports: PhaseReport[] = [];
    for (const fault of faults) {
      say(`${fault.name} begins`);
      const report = await runPhase(cluster, fault, background, say);
      reports.push(report);
      say(formatPhase(report));
    }
    const failures = cluster.failures();
    if (failures.length > 0) {
      const about = 'lines of errors in the logs of the masters';
      reports.push({ name: 'logs', about, figures: [], violations: failures.slice(0, 20) });
      say(formatPhase(reports.at(-1)!));
    }
    return reports;
  } finally {
    await cluster.close();
  }
}

/** One part as lines of text. */
export function formatPhase({ name, about, figures, violations }: PhaseReport): string {
  return [
    `${name}: ${about}`,
    ...figures.map((figure) => `  ${figure}`),
    ...violations.map((violation) => `  BROKEN ${violation}`),
  ].join('\n');
}

/** @returns how long it took, milliseconds */
async function joinAll(cluster: TestCluster, plan: RunPlan): Promise<number> {
  const joinToken = await cluster.invite();
  const publishes = cluster.pools.map((_, machine) =>
    Array.from({ length: plan.topics }, (_, index) => `/pool/${machine + 1}/${index + 1}`),
  );
  // One of each machine in turn.
  const topics = publishes[0]!.flatMap((_, index) => publishes.map((own) => own[index]!));
  const begunMs = performance.now();
  await Promise.all(
    cluster.pools.map((pool, machine) =>
      pool.do('join', {
        url: cluster.urlOf(machine),
        joinToken,
        count: plan.clients,
        publishes: publishes[machine]!,
        topics,
        topicsPerMember: plan.topicsPerClient,
        periodMs: plan.periodMs,
      }),
    ),
  );
  const tookMs = performance.now() - begunMs;
  const { problems } = await settle(() => findAbsent(cluster), TIMEOUT_MS, plan.say);
  if (problems.length > 0) throw new Error(problems.join('\n'));
  return tookMs;
}
