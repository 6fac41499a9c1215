import { ExpectedState } from '../faults/expected-state.ts';
import { Workload } from '../faults/workload.ts';
import { pause } from '../pause.ts';
import type { Random } from '../random.ts';
import { findDisagreement, findValueDisagreement, settle } from './agreement.ts';
import type { PublisherRow, ReceptionRow } from './clients/reception.ts';
import type { TestCluster } from './cluster.ts';
import type { Fault } from './faults.ts';
import { judge } from './judge.ts';

const PERIOD_MS = 250;

/** Polls the number of clients without a connection, from its creation until `end`. */
class ConnectionWatch {
  readonly #cluster: TestCluster;
  readonly #begunMs = performance.now();
  readonly #watching: Promise<void>;
  #isWatching = true;
  #mostAway = 0;
  #lastAwayMs = 0;

  constructor(cluster: TestCluster) {
    this.#cluster = cluster;
    this.#watching = this.#watch();
  }

  /** @returns what was seen, in words */
  async end(): Promise<string> {
    this.#isWatching = false;
    await this.#watching;
    if (this.#mostAway === 0) return 'no client was seen without a connection';
    const backAfter = (this.#lastAwayMs / 1000).toFixed(1);
    return `at most ${this.#mostAway} clients at once had no connection, the last one until ${backAfter} s after the fault began`;
  }

  async #watch(): Promise<void> {
    while (this.#isWatching) {
      // A process that has ended is reported by those that wait for its clients.
      const counts = await Promise.all(
        this.#cluster.pools.map((pool) => pool.do('away').catch(() => 0)),
      );
      const away = counts.reduce((sum, count) => sum + count, 0);
      if (away > 0) this.#lastAwayMs = performance.now() - this.#begunMs;
      this.#mostAway = Math.max(this.#mostAway, away);
      await pause(PERIOD_MS);
    }
  }
}

/** Pattern of the topics that pools publish on. */
export const POOL_TOPICS = '^/pool/';
/** Past this something hangs. Not a measure: a busy machine takes long, too. */
const TIMEOUT_MS = 180_000;
/** Pause between two requests of the background workload, milliseconds. */
const STEP_PAUSE_MS = 50;
/** Requests before a fault, so that there is state to lose. */
const STEPS_BEFORE = 20;
const MAX_VIOLATIONS = 20;
const GAPS = 'ubii_cluster_gaps_total';

/** Result of one phase of a run. */
export interface PhaseReport {
  readonly name: string;
  readonly about: string;
  /** Figures, in words. */
  readonly figures: readonly string[];
  /** Against the specification, in words; nothing may be. */
  readonly violations: readonly string[];
}

/** Stores, starts, deletes and invites at all masters in turn, and keeps the state that the masters acknowledged. */
export class BackgroundWorkload {
  readonly expected = new ExpectedState();
  readonly workload: Workload;
  #isWorking = false;

  constructor(cluster: TestCluster, random: Random) {
    this.workload = new Workload(random, this.expected, (request) =>
      cluster.ask(random.pick(cluster.present), request),
    );
  }

  /** Works until `stop` of what it returns. */
  work(): () => Promise<void> {
    this.#isWorking = true;
    const working = (async () => {
      while (this.#isWorking) {
        await this.workload.step();
        await pause(STEP_PAUSE_MS);
      }
    })();
    return () => {
      this.#isWorking = false;
      return working;
    };
  }
}

/** Runs one fault during the workloads, and finds what it broke. */
export async function runPhase(
  cluster: TestCluster,
  fault: Fault,
  background: BackgroundWorkload,
  say: (text: string) => void,
): Promise<PhaseReport> {
  const gapsBefore = await gapsOf(cluster);
  await each(cluster, (pool) => pool.do('begin'));
  for (let steps = 0; steps < STEPS_BEFORE; steps += 1) await background.workload.step();
  const stopWork = background.work();
  const watch = new ConnectionWatch(cluster);
  try {
    await fault.run(cluster, say);
  } finally {
    await stopWork();
  }
  const waited = await waitForAll(cluster, background, watch, say);
  const receptions = (await each(cluster, (pool) => pool.do('rows'))).flat();
  const gapsAfter = await gapsOf(cluster);
  const noticed = new Set(
    [...gapsAfter.keys()].filter((index) => gapsAfter[index]! > (gapsBefore[index] ?? 0)),
  );
  const indexOf = (url: string): number => cluster.indexOf(url);
  const { publishers } = waited;
  const judged = judge({ publishers, receptions, indexOf, mayLose: fault.mayLose, noticed });
  const { workload } = background;
  return {
    name: fault.name,
    about: fault.about,
    figures: [
      ...waited.figures,
      `${judged.received} records received, ${movedOf(receptions)}; ${judged.again} twice, ${judged.disorder} out of order`,
      ...Object.entries(judged.missing).map(([reason, count]) => `${count} missing: ${reason}`),
      `${workload.acknowledged} requests acknowledged since the first phase, ${workload.refused} not; ${waited.lost} of what was acknowledged is lost`,
      ...cluster.figures(),
    ],
    violations: [...judged.violations, ...waited.problems].slice(0, MAX_VIOLATIONS),
  };
}

/** Observations until everything is back after a fault. */
interface Waited {
  readonly figures: readonly string[];
  readonly problems: readonly string[];
  readonly publishers: readonly PublisherRow[];
  /** Number of losses of what was acknowledged, at all masters. */
  readonly lost: number;
}

async function waitForAll(
  cluster: TestCluster,
  background: BackgroundWorkload,
  watch: ConnectionWatch,
  say: (text: string) => void,
): Promise<Waited> {
  const back = await settle(() => findAbsent(cluster), TIMEOUT_MS, say);
  const connections = await watch.end();
  // A record of each topic after all are back: it shows what is missing before it.
  await pause(2_000);
  const publishers = (await each(cluster, (pool) => pool.do('stop'))).flat();
  const lasts = Object.fromEntries(publishers.map(({ topic, last }) => [topic, last]));
  const arrived = await settle(() => findBehind(cluster, lasts), TIMEOUT_MS, say);
  const topics = new RegExp(POOL_TOPICS);
  const agreed = await settle(() => findDisagreement(cluster, topics), TIMEOUT_MS, say);
  const values = await settle(
    () => findValueDisagreement(cluster, POOL_TOPICS, lasts),
    TIMEOUT_MS / 10,
    say,
  );
  const kept = await settle(() => findLosses(cluster, background.expected), TIMEOUT_MS / 3, say);
  return {
    figures: [
      `all clients back after ${seconds(back.tookMs)}, newest records after ${seconds(arrived.tookMs)}, masters agree after ${seconds(agreed.tookMs)}`,
      connections,
    ],
    problems: [back, arrived, agreed, values, kept].flatMap(({ problems }) => problems),
    publishers,
    lost: kept.problems.length,
  };
}

/** Does the same at the clients of all masters. */
export function each<T>(
  cluster: TestCluster,
  fn: (pool: TestCluster['pools'][number]) => Promise<T>,
): Promise<T[]> {
  return Promise.all(cluster.pools.map(fn));
}

/** Clients that are not connected, or do not know the other masters, or changed their identity. */
export async function findAbsent(cluster: TestCluster): Promise<string[]> {
  const states = await each(cluster, (pool) => pool.do('state', cluster.size - 1));
  const gone = cluster.ended();
  const absent = states.flatMap((state, index) => {
    if (state === undefined) return [];
    const { connected, members, identityChanges, unaware, others } = state;
    const doing = Object.entries(others).map(([situation, count]) => `${count} ${situation}`);
    const whose = `of the clients of machine ${index + 1}`;
    return [
      ...(connected < members
        ? [`${members - connected} ${whose} have no connection (${doing.slice(0, 3).join('; ')})`]
        : []),
      ...(unaware > 0 ? [`${unaware} ${whose} do not know the other masters`] : []),
      ...(identityChanges > 0 ? [`${identityChanges} ${whose} changed their identity`] : []),
    ];
  });
  return [...gone, ...absent];
}

async function findBehind(
  cluster: TestCluster,
  lasts: Readonly<Record<string, number>>,
): Promise<string[]> {
  const counts = await each(cluster, (pool) => pool.do('behind', { ...lasts }));
  const count = counts.reduce((sum, one) => sum + one, 0);
  return count === 0 ? [] : [`${count} subscriptions do not have the newest record`];
}

/** Acknowledged changes that a master has lost, for each master. */
async function findLosses(cluster: TestCluster, expected: ExpectedState): Promise<string[]> {
  const losses = await Promise.all(
    cluster.present.map(async (index) => {
      const found = await expected.findLosses((request) => cluster.ask(index, request));
      return found.map((loss) => `at master ${index + 1}: ${loss}`);
    }),
  );
  return losses.flat();
}

function gapsOf(cluster: TestCluster): Promise<number[]> {
  return Promise.all(cluster.pools.map((_, index) => cluster.metric(index, GAPS)));
}

function movedOf(rows: readonly ReceptionRow[]): string {
  const moved = rows.filter(({ moved: hasMoved }) => hasMoved);
  const sum = moved.reduce((all, { received }) => all + received, 0);
  return `${sum} of them by clients that reconnected`;
}

function seconds(ms: number): string {
  return `${(ms / 1000).toFixed(1)} s`;
}
