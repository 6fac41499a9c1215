import type { Client, Session } from '@ubii/proto';

import { pause } from '../pause.ts';
import type { TestCluster } from './cluster.ts';

const PERIOD_MS = 500;
/** Interval of messages about a long wait. */
const SAY_MS = 20_000;

/** Result of waiting for something. */
interface Settled {
  /** How long it took, milliseconds. */
  readonly tookMs: number;
  /** Problems that were left at the time limit; empty when there are none. */
  readonly problems: readonly string[];
}

/**
 * Polls until there are no problems, or until the time limit.
 *
 * @param look finds problems; what it throws is a problem, too
 * @param say receives the problems that are left, now and then
 */
export async function settle(
  look: () => Promise<readonly string[]>,
  timeoutMs: number,
  say: (text: string) => void,
): Promise<Settled> {
  const begunMs = performance.now();
  let saidMs = 0;
  for (;;) {
    const problems = await look().catch((error: unknown) => [String(error)]);
    const tookMs = performance.now() - begunMs;
    if (problems.length === 0 || tookMs > timeoutMs) return { tookMs, problems };
    if (tookMs - saidMs > SAY_MS) {
      saidMs = tookMs;
      say(`  after ${Math.round(tookMs / 1000)} s: ${problems.slice(0, 3).join('; ')}`);
    }
    await pause(PERIOD_MS);
  }
}

/** Time for values to reach a new subscriber, milliseconds. */
const VALUES_MS = 1_500;

/** What a master says that all should say. */
export interface Account {
  /** Ids of clients, with their state. */
  readonly clients: ReadonlyMap<string, string>;
  readonly topics: ReadonlyMap<string, string>;
  /** Sessions that are open, and whether they run. */
  readonly sessions: ReadonlyMap<string, string>;
  readonly storedSessions: ReadonlyMap<string, string>;
}

/** Asks a master. @param topics pattern of the topics that count @throws Error when it does not answer */
export async function accountOf(
  cluster: TestCluster,
  index: number,
  topics: RegExp,
): Promise<Account> {
  const [clients, list, sessions, stored] = await Promise.all([
    cluster.ask(index, { topic: '/services/client/get_list', clientList: {} }),
    cluster.ask(index, { topic: '/services/topic_list' }),
    cluster.ask(index, { topic: '/services/session/runtime/get_list' }),
    cluster.ask(index, { topic: '/services/session/database/get_list' }),
  ]);
  const found = (list.stringList?.elements ?? []).filter((topic) => topics.test(topic));
  return {
    clients: new Map((clients.clientList?.elements ?? []).map(describeClient)),
    topics: new Map(found.map((topic) => [topic, 'there'])),
    sessions: new Map((sessions.sessionList?.elements ?? []).map(describeSession)),
    storedSessions: new Map(
      (stored.sessionList?.elements ?? []).map(({ name, description }) => [name, description]),
    ),
  };
}

/** Sentences about how masters differ from the first one. Empty when they agree. */
export async function findDisagreement(cluster: TestCluster, topics: RegExp): Promise<string[]> {
  const indexes = cluster.present;
  const accounts = await Promise.all(indexes.map((index) => accountOf(cluster, index, topics)));
  const first = accounts[0]!;
  return accounts.flatMap((account, place) =>
    (Object.keys(first) as (keyof Account)[]).flatMap((kind) =>
      differences(first[kind], account[kind]).map(
        (what) => `${kind}: master ${indexes[0]! + 1} and master ${indexes[place]! + 1}: ${what}`,
      ),
    ),
  );
}

/** How the values that stand differ between masters, in words. @param lasts those that were published last */
export async function findValueDisagreement(
  cluster: TestCluster,
  regex: string,
  lasts: Readonly<Record<string, number>>,
): Promise<string[]> {
  const wanted = new Map(Object.entries(lasts).map(([topic, last]) => [topic, String(last)]));
  const all = await Promise.all(
    cluster.present.map(async (index) => {
      const url = cluster.ownUrlOf(index);
      const values = await cluster.pools[index]!.do('values', url, regex, VALUES_MS);
      const found = new Map(Object.entries(values).map(([topic, value]) => [topic, String(value)]));
      return differences(wanted, found).map((what) => `values at master ${index + 1}: ${what}`);
    }),
  );
  return all.flat();
}

function describeClient({ id, state }: Client): [string, string] {
  return [id, `in state ${state}`];
}

function describeSession({ id, extension }: Session): [string, string] {
  return [id, `in state ${extension?.state ?? 0}`];
}

/** The first few entries that differ, in words. */
function differences(a: ReadonlyMap<string, string>, b: ReadonlyMap<string, string>): string[] {
  const keys = new Set([...a.keys(), ...b.keys()]);
  const different = [...keys].filter((key) => a.get(key) !== b.get(key));
  const words = different
    .slice(0, 3)
    .map((key) => `${key} is ${a.get(key) ?? 'missing'} / ${b.get(key) ?? 'missing'}`);
  if (different.length > words.length) words.push(`${different.length} differ in all`);
  return words;
}
