import { FakeClock } from '@ubii/timing/testing';
import type { MasterMetrics } from '../../src/core/monitoring/metric-family.ts';
import {
  MemoryDocuments,
  MemoryHub,
  MemoryStorage,
  PlainSeal,
  TestMaster,
  type TestMasterOptions,
} from '../../src/testing/index.ts';
import { MemoryOwnerTable, type MemoryOwners } from '../../src/testing/memory-owners.ts';

/** Ids that the masters before a master may have given. */
const IDS_PER_MASTER = 10_000;

/** Several masters in memory that carry messages to each other; they share what a cluster keeps. */
export class ClusterWorld {
  readonly clock = new FakeClock();
  readonly hub = new MemoryHub();
  readonly owners = new MemoryOwnerTable();
  readonly storage = new MemoryStorage();
  readonly grants = new MemoryDocuments();
  readonly masters: TestMaster[] = [];
  readonly #owners = new Map<TestMaster, MemoryOwners>();

  /** Starts one more master, and waits until all know each other. */
  async add(options: TestMasterOptions = {}): Promise<TestMaster> {
    const number = this.masters.length;
    const owners = this.owners.open();
    const master = new TestMaster({
      clock: this.clock,
      idsGiven: number * IDS_PER_MASTER,
      grants: this.grants,
      storage: this.storage,
      cluster: { name: 'test', bus: this.hub.bus(), seal: new PlainSeal(), owners },
      name: `master ${number + 1}`,
      ...options,
    });
    this.masters.push(master);
    this.#owners.set(master, owners);
    await this.pass(50);
    return master;
  }

  /** Takes all that masters share away from one of them, or gives it back: to others it is lost. */
  setReachable(master: TestMaster, isReachable: boolean): void {
    this.hub.setReachable(master.master.id, isReachable);
    this.#owners.get(master)!.setReachable(isReachable);
  }

  /** Tells every master of the invitations that others changed, as their store does. */
  tellGrants(): void {
    for (const [key, { json }] of this.grants.documents()) {
      this.grants.edit(key, JSON.stringify(json));
    }
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

/** Two masters, a publisher at the first and a subscriber to `/a` at the second. */
export async function publisherAndSubscriber() {
  const [world, a, b] = await clusterOf(2);
  const publisher = await a!.extension('publisher');
  const subscriber = await b!.extension('subscriber');
  await subscriber.subscribe({ subscribeTopics: ['/a'] });
  await world.pass();
  return { world, a: a!, b: b!, publisher, subscriber };
}

/** Returns the values of `/a` that a client gets that subscribes only now. */
export async function laterValues(world: ClusterWorld, master: TestMaster): Promise<unknown[]> {
  const late = await master.extension('late');
  await late.subscribe({ subscribeTopics: ['/a'] });
  await world.pass();
  return late.takeValues();
}
