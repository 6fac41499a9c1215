import { FakeClock } from '@ubii/timing/testing';
import type { MasterMetrics } from '../../src/core/monitoring/metric-family.ts';
import {
  MemoryDocuments,
  MemoryHub,
  TestMaster,
  type TestMasterOptions,
} from '../../src/testing/index.ts';
import { MemoryOwners } from './memory-owners.ts';

/** Ids that the masters before a master may have given. */
const IDS_PER_MASTER = 10_000;

/** Several masters in memory that carry messages to each other; they share what a cluster keeps. */
export class ClusterWorld {
  readonly clock = new FakeClock();
  readonly hub = new MemoryHub();
  readonly owners = new MemoryOwners();
  readonly grants = new MemoryDocuments();
  readonly masters: TestMaster[] = [];

  /** Starts one more master, and waits until all know each other. */
  async add(options: TestMasterOptions = {}): Promise<TestMaster> {
    const number = this.masters.length;
    const master = new TestMaster({
      clock: this.clock,
      idsGiven: number * IDS_PER_MASTER,
      grants: this.grants,
      cluster: { name: 'test', bus: this.hub.bus(), owners: this.owners },
      name: `master ${number + 1}`,
      ...options,
    });
    this.masters.push(master);
    await this.pass(50);
    return master;
  }

  /** Records that were sent to other masters so far, once for each. */
  crossed(): number {
    return this.masters.reduce((sum, { master }) => sum + crossedOf(master.metrics()), 0);
  }

  /** Lets messages arrive, and time pass. */
  async pass(durationMs = 50): Promise<void> {
    await this.masters[0]!.pass(durationMs);
  }
}

function crossedOf(metrics: MasterMetrics): number {
  const family = metrics.find(({ name }) => name === 'ubii_cluster_records_sent_total');
  return family?.values[0]?.value ?? 0;
}

/** Masters that know each other. */
export async function clusterOf(count: number): Promise<[ClusterWorld, ...TestMaster[]]> {
  const world = new ClusterWorld();
  for (let i = 0; i < count; i++) await world.add();
  return [world, ...world.masters];
}
