import { pause } from '../pause.ts';
import type { TestCluster } from './cluster.ts';

/** A fault of a cluster, which one phase of a run injects. */
export interface Fault {
  /** For `--only`. */
  readonly name: string;
  readonly about: string;
  /** The storage of NATS is lost, and with it the documents that no master has open. */
  readonly losesStorage?: boolean;
  /** Injects the fault and repairs it; resolves when nothing is broken any more. @param say prints what happens */
  run(cluster: TestCluster, say: (text: string) => void): Promise<void>;
  /**
   * Whether records may be lost between a publisher and a subscriber whose clients were at these masters when it began
   * and stayed there, by the specification of clusters.
   */
  mayLose(publisherAt: number, subscriberAt: number): boolean;
}

/** Longer than a master is waited for, so that it counts as lost. [CU-3] */
const AWAY_MS = 6_000;
/** A calm part: records for a comparison. */
const CALM_MS = 3_000;

const FIRST = 0;
const SECOND = 1;
const LAST = 2;

const calm: Fault = {
  name: 'calm',
  about: 'nothing is done: no record may be missing',
  run: () => pause(CALM_MS),
  mayLose: () => false,
};

const killMaster: Fault = {
  name: 'kill-master',
  about: 'kill -9 of a master, and a start on the same port after its clients have moved',
  async run(cluster, say) {
    await cluster.kill(LAST);
    await pause(AWAY_MS);
    await cluster.restart(LAST);
    say('started again');
  },
  mayLose: (publisherAt, subscriberAt) => publisherAt === LAST || subscriberAt === LAST,
};

const killNats: Fault = {
  name: 'kill-nats',
  about: 'kill -9 of NATS, and a start with what it had stored',
  async run(cluster) {
    await cluster.nats.kill();
    await pause(AWAY_MS);
    await cluster.nats.restart();
  },
  mayLose: (publisherAt, subscriberAt) => publisherAt !== subscriberAt,
};

const loseStorage: Fault = {
  name: 'lose-storage',
  about: 'kill -9 of NATS, and a start with an empty storage',
  async run(cluster) {
    await cluster.nats.kill();
    await cluster.nats.empty();
    await pause(AWAY_MS);
    await cluster.nats.restart();
  },
  mayLose: (publisherAt, subscriberAt) => publisherAt !== subscriberAt,
};

const partition: Fault = {
  name: 'partition',
  about: 'one master is cut off from NATS and the others, and comes back',
  async run(cluster) {
    cluster.cut(FIRST);
    await pause(2 * AWAY_MS);
    cluster.heal(FIRST);
  },
  mayLose: (publisherAt, subscriberAt) =>
    publisherAt !== subscriberAt && (publisherAt === FIRST || subscriberAt === FIRST),
};

const shortPartition: Fault = {
  name: 'short-partition',
  about: 'one master is cut off for less time than makes it a lost one',
  async run(cluster) {
    cluster.cut(SECOND);
    await pause(1_000);
    cluster.heal(SECOND);
  },
  mayLose: (publisherAt, subscriberAt) =>
    publisherAt !== subscriberAt && (publisherAt === SECOND || subscriberAt === SECOND),
};

const rollingRestart: Fault = {
  name: 'rolling-restart',
  about: 'all masters are ended in good order and started again, one after the other',
  async run(cluster, say) {
    for (let index = 0; index < cluster.size; index += 1) {
      await cluster.stop(index);
      await cluster.restart(index);
      say(`master ${index + 1} is there again`);
      await pause(AWAY_MS);
    }
  },
  mayLose: () => true,
};

/** Every fault, in the order of a run. */
export const FAULTS: readonly Fault[] = [
  calm,
  killMaster,
  killNats,
  shortPartition,
  partition,
  rollingRestart,
  loseStorage,
];
