import { Ledger } from '../faults/ledger.ts';
import { Scribe } from '../faults/scribe.ts';
import { pause } from '../pause.ts';
import type { Random } from '../random.ts';
import { findDisagreement, findValueDisagreement } from './agreement.ts';
import type { TestCluster } from './cluster.ts';
import { ConnectionWatch } from './connection-watch.ts';
import type { PublisherRow, ReceptionRow } from './crowd/reception.ts';
import type { Fault } from './faults/fault.ts';
import { judge } from './judge.ts';
import { settle } from './settle.ts';

/** Topics that crowds publish on. */
export const CROWD_TOPICS = '^/crowd/';
/** Past this something hangs. A limit on waiting, not a measure: a busy machine takes long, too. */
const PATIENCE_MS = 180_000;
/** Pause between two requests of the host, milliseconds. */
const HOST_PAUSE_MS = 50;
/** Requests of the host before a fault: something is there to lose. */
const TURNS_BEFORE = 20;
const MOST_VIOLATIONS = 20;
const GAPS = 'ubii_cluster_gaps_total';

/** Result of one part of a run. */
export interface PartReport {
  readonly name: string;
  readonly about: string;
  /** Figures, in words. */
  readonly figures: readonly string[];
  /** Against the specification, in words; nothing may be. */
  readonly violations: readonly string[];
}

/** A host that stores, starts, deletes and invites at all masters in turn, and a ledger of what was acknowledged. */
export class Host {
  readonly ledger = new Ledger();
  readonly scribe: Scribe;
  #isWorking = false;

  constructor(cluster: TestCluster, random: Random) {
    this.scribe = new Scribe(random, this.ledger, (request) =>
      cluster.ask(random.pick(cluster.present), request),
    );
  }

  /** Works until `stop` of what it returns. */
  work(): () => Promise<void> {
    this.#isWorking = true;
    const working = (async () => {
      while (this.#isWorking) {
        await this.scribe.turn();
        await pause(HOST_PAUSE_MS);
      }
    })();
    return () => {
      this.#isWorking = false;
      return working;
    };
  }
}

/** Runs one fault while clients publish and a host works, and looks what became of it. */
export async function runPart(
  cluster: TestCluster,
  fault: Fault,
  host: Host,
  say: (text: string) => void,
): Promise<PartReport> {
  const gapsBefore = await gapsOf(cluster);
  await each(cluster, (crowd) => crowd.do('begin'));
  for (let turns = 0; turns < TURNS_BEFORE; turns += 1) await host.scribe.turn();
  const stopWork = host.work();
  const watch = new ConnectionWatch(cluster);
  try {
    await fault.run(cluster, say);
  } finally {
    await stopWork();
  }
  const waited = await waitForAll(cluster, host, watch, say);
  const receptions = (await each(cluster, (crowd) => crowd.do('rows'))).flat();
  const gapsAfter = await gapsOf(cluster);
  const noticed = new Set(
    [...gapsAfter.keys()].filter((index) => gapsAfter[index]! > (gapsBefore[index] ?? 0)),
  );
  const indexOf = (url: string): number => cluster.indexOf(url);
  const { publishers } = waited;
  const judged = judge({ publishers, receptions, indexOf, mayLose: fault.mayLose, noticed });
  const { scribe } = host;
  return {
    name: fault.name,
    about: fault.about,
    figures: [
      ...waited.figures,
      `${judged.received} records received, ${movedOf(receptions)}; ${judged.again} twice, ${judged.disorder} out of order`,
      ...Object.entries(judged.missing).map(([reason, count]) => `${count} missing: ${reason}`),
      `${scribe.acknowledged} requests acknowledged since the first part, ${scribe.refused} not; ${waited.lost} of what was acknowledged is lost`,
      ...cluster.figures(),
    ],
    violations: [...judged.violations, ...waited.problems].slice(0, MOST_VIOLATIONS),
  };
}

/** What was seen while all was waited for that has to come back. */
interface Waited {
  readonly figures: readonly string[];
  readonly problems: readonly string[];
  readonly publishers: readonly PublisherRow[];
  /** Number of losses of what was acknowledged, at all masters. */
  readonly lost: number;
}

async function waitForAll(
  cluster: TestCluster,
  host: Host,
  watch: ConnectionWatch,
  say: (text: string) => void,
): Promise<Waited> {
  const back = await settle(() => findAbsent(cluster), PATIENCE_MS, say);
  const connections = await watch.end();
  // A record of each topic after all are back: it shows what is missing before it.
  await pause(2_000);
  const publishers = (await each(cluster, (crowd) => crowd.do('stop'))).flat();
  const lasts = Object.fromEntries(publishers.map(({ topic, last }) => [topic, last]));
  const arrived = await settle(() => findBehind(cluster, lasts), PATIENCE_MS, say);
  const topics = new RegExp(CROWD_TOPICS);
  const agreed = await settle(() => findDisagreement(cluster, topics), PATIENCE_MS, say);
  const values = await settle(
    () => findValueDisagreement(cluster, CROWD_TOPICS, lasts),
    PATIENCE_MS / 10,
    say,
  );
  const kept = await settle(() => findLosses(cluster, host.ledger), PATIENCE_MS / 3, say);
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
  fn: (crowd: TestCluster['crowds'][number]) => Promise<T>,
): Promise<T[]> {
  return Promise.all(cluster.crowds.map(fn));
}

/** Clients that are not connected, or do not know the other masters, or changed their identity. */
export async function findAbsent(cluster: TestCluster): Promise<string[]> {
  const states = await each(cluster, (crowd) => crowd.do('state', cluster.size - 1));
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
  const counts = await each(cluster, (crowd) => crowd.do('behind', { ...lasts }));
  const count = counts.reduce((sum, one) => sum + one, 0);
  return count === 0 ? [] : [`${count} subscriptions do not have the newest record`];
}

/** What was acknowledged and is not there, at each master. */
async function findLosses(cluster: TestCluster, ledger: Ledger): Promise<string[]> {
  const losses = await Promise.all(
    cluster.present.map(async (index) => {
      const found = await ledger.findLosses((request) => cluster.ask(index, request));
      return found.map((loss) => `at master ${index + 1}: ${loss}`);
    }),
  );
  return losses.flat();
}

function gapsOf(cluster: TestCluster): Promise<number[]> {
  return Promise.all(cluster.crowds.map((_, index) => cluster.metric(index, GAPS)));
}

function movedOf(rows: readonly ReceptionRow[]): string {
  const moved = rows.filter(({ moved: hasMoved }) => hasMoved);
  const sum = moved.reduce((all, { received }) => all + received, 0);
  return `${sum} of them by clients that reconnected`;
}

function seconds(ms: number): string {
  return `${(ms / 1000).toFixed(1)} s`;
}
