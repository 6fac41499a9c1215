import { createClient } from '@ubii/client-web/node';

import { pause } from '../../pause.ts';
import { Member } from './member.ts';
import type { PublisherRow, ReceptionCounts, ReceptionRow } from './reception.ts';

/** Members that join at the same time. */
const JOIN_AT_ONCE = 20;

/** The clients of one machine. */
export interface PoolPlan {
  readonly url: string;
  readonly joinToken: string;
  readonly count: number;
  /** Topics that the first members publish on, one each. */
  readonly publishes: readonly string[];
  /** All topics; each member subscribes to some. */
  readonly topics: readonly string[];
  readonly topicsPerMember: number;
  /** Time between two records of a topic, milliseconds. */
  readonly periodMs: number;
}

/** State of a pool. */
export interface PoolState {
  readonly connected: number;
  /** Number of clients without a connection, by what they do. */
  readonly others: Readonly<Record<string, number>>;
  /** Members that know fewer than so many other masters. */
  readonly unaware: number;
  readonly identityChanges: number;
  readonly members: number;
}

/** Many clients in one process. Each counts what it receives. */
export class ClientPool {
  readonly #plan: PoolPlan;
  readonly #members: readonly Member[];
  #timer: NodeJS.Timeout | undefined;

  constructor(plan: PoolPlan) {
    this.#plan = plan;
    const { topics, topicsPerMember } = plan;
    this.#members = Array.from({ length: plan.count }, (_, index) => {
      // Neighbours in the list of topics have publishers at different masters.
      const first = (index * topicsPerMember) % topics.length;
      const own = Array.from(
        { length: Math.min(topicsPerMember, topics.length) },
        (_, offset) => topics[(first + offset) % topics.length]!,
      );
      const name = `pool ${index}`;
      const { url, joinToken } = plan;
      return new Member({ url, joinToken, name, topics: own, publishes: plan.publishes[index] });
    });
  }

  async join(): Promise<void> {
    const waiting = [...this.#members];
    const joinOthers = async (): Promise<void> => {
      for (let member = waiting.pop(); member !== undefined; member = waiting.pop()) {
        await member.join();
      }
    };
    await Promise.all(Array.from({ length: JOIN_AT_ONCE }, joinOthers));
  }

  /** Number of members that have no connection. */
  away(): number {
    return this.#members.filter(({ isConnected }) => !isConnected).length;
  }

  /** @param others masters that a member should know besides its own */
  state(others: number): PoolState {
    const members = this.#members;
    const connected = members.filter(({ isConnected }) => isConnected);
    return {
      connected: connected.length,
      others: countEach(
        members.filter(({ isConnected }) => !isConnected).map(({ situation }) => situation),
      ),
      unaware: connected.filter(({ knownMasters }) => knownMasters < others).length,
      identityChanges: members.reduce((sum, { identityChanges }) => sum + identityChanges, 0),
      members: members.length,
    };
  }

  /** A phase of the run begins: records are published until `stop`. */
  begin(): void {
    for (const member of this.#members) {
      member.begin();
      for (const reception of member.receptions) reception.take();
    }
    const publishers = this.#members.filter(({ publishes }) => publishes !== undefined);
    if (publishers.length === 0) return;
    let next = 0;
    this.#timer = setInterval(() => {
      publishers[next % publishers.length]!.publishNext();
      next += 1;
    }, this.#plan.periodMs / publishers.length);
  }

  /** No more records. */
  stop(): PublisherRow[] {
    clearInterval(this.#timer);
    return this.#members.flatMap(({ publishes: topic, home, hasMoved, last }) =>
      topic === undefined ? [] : [{ topic, home, moved: hasMoved, last }],
    );
  }

  /** Receptions that have not come to the last number of their topic. */
  behind(lasts: Readonly<Record<string, number>>): number {
    let count = 0;
    for (const { receptions } of this.#members) {
      for (const { topic, last } of receptions) if (last !== lasts[topic]) count += 1;
    }
    return count;
  }

  /** Counts of records since `begin`: one row for all members with the same topic, master and `moved`. */
  rows(): ReceptionRow[] {
    const rows = new Map<string, ReceptionRow>();
    for (const { home, hasMoved, receptions } of this.#members) {
      for (const reception of receptions) {
        const { topic } = reception;
        const key = `${topic} ${home} ${hasMoved}`;
        const row = rows.get(key) ?? { ...NOTHING, topic, home, moved: hasMoved };
        rows.set(key, { ...row, ...sumOf(row, reception.take()) });
      }
    }
    return [...rows.values()];
  }

  async close(): Promise<void> {
    clearInterval(this.#timer);
    await Promise.all(this.#members.map((member) => member.close()));
  }
}

const NOTHING: ReceptionCounts = { received: 0, missing: 0, again: 0, disorder: 0 };

function countEach(texts: readonly string[]): Record<string, number> {
  const counts: Record<string, number> = {};
  for (const text of texts) counts[text] = (counts[text] ?? 0) + 1;
  return counts;
}

function sumOf(a: ReceptionCounts, b: ReceptionCounts): ReceptionCounts {
  return {
    received: a.received + b.received,
    missing: a.missing + b.missing,
    again: a.again + b.again,
    disorder: a.disorder + b.disorder,
  };
}

/** The current values at a master, as a new subscriber gets them. @param waitMs for them to come */
export async function valuesAt(
  url: string,
  regex: string,
  waitMs: number,
): Promise<Record<string, unknown>> {
  const client = createClient({ url, name: 'auditor' });
  await client.connect();
  try {
    const values: Record<string, unknown> = {};
    const subscription = client.subscribe({ regex }, { format: 'double' });
    subscription.onRecord(({ topic, value }) => (values[topic] = value));
    await subscription.ready;
    await pause(waitMs);
    return values;
  } finally {
    await client.close();
  }
}
