import { describe, expect, it } from 'vitest';
import { testAccount } from '../../testing/index.ts';
import type { Account } from '../shares/account.ts';
import { RESOURCE } from '../shares/resources.ts';
import type { TopicEntry, TopicOwner } from './topic-entry.ts';
import { TopicTable } from './topic-table.ts';

const FIRST_EPOCH = 1000;

function createTable(keptRemovals = 10) {
  const master = testAccount();
  const table = new TopicTable([], FIRST_EPOCH, keptRemovals, master);
  const publish = (topic: string, byteLength = 1): TopicEntry => {
    const entry = table.getOrCreate(topic);
    table.store(entry, new Uint8Array(byteLength), 3, 0);
    return entry;
  };
  const changesSince = (epoch: number) => {
    const { entries, removed, isReset, epoch: next } = table.takeChanges(epoch);
    return { topics: entries.map(({ topic }) => topic), removed, isReset, next };
  };
  return { table, master, publish, changesSince };
}

const subscriberOf = (account: Account) =>
  ({ account, outbox: { handleGone: () => undefined } }) as never;

describe('TopicTable', () => {
  it('counts the bytes of what it retains', () => {
    const { table, publish } = createTable();
    publish('/a', 10);
    publish('/a', 4);
    const entry = publish('/b', 5);
    expect(table.retainedBytes).toBe(9);
    table.deleteValue(entry);
    table.deleteValue(entry);
    expect(table.retainedBytes).toBe(4);
  });

  it('forgets a topic with its last reason to be [TD-41]', () => {
    const { table, publish } = createTable();
    const entry = publish('/a');
    const subscriber = subscriberOf(testAccount());
    entry.subscribers.set(subscriber, 0);
    table.deleteValue(entry);
    expect(table.get('/a')).toBe(entry);
    entry.subscribers.delete(subscriber);
    table.forgetIfUnused(entry);
    expect(table.get('/a')).toBeUndefined();
  });

  it('takes a topic from its owner with its value [TD-19]', () => {
    const { table, publish } = createTable();
    const owner: TopicOwner = { id: 'ada', ownedTopics: new Set(), account: testAccount() };
    const entry = table.getOrCreate('/a');
    table.own(entry, owner);
    publish('/a');
    table.deleteValue(entry);
    expect(owner.ownedTopics.size).toBe(0);
    expect(entry.owner).toBeUndefined();
  });

  it('counts a topic for its owner, then for its oldest subscriber [AC-80]', () => {
    const { table, master, publish } = createTable();
    const [ada, ben, cleo] = [testAccount(), testAccount(), testAccount()] as const;
    const [bens, cleos] = [subscriberOf(ben), subscriberOf(cleo)] as const;
    const entry = table.getOrCreate('/a');
    entry.subscribers.set(bens, 0);
    entry.subscribers.set(cleos, 0);
    table.settlePayer(entry);
    const used = () =>
      [master, ada, ben, cleo].map((account) => [
        account.used(RESOURCE.topics),
        account.used(RESOURCE.retainedBytes),
      ]);
    const nothing = [0, 0];
    expect(used()).toEqual([nothing, nothing, [1, 0], nothing]);
    table.own(entry, { id: 'ada', ownedTopics: new Set(), account: ada });
    publish('/a', 10);
    publish('/a', 7);
    expect(used()).toEqual([nothing, [1, 7], nothing, nothing]);
    entry.subscribers.delete(bens);
    table.deleteValue(entry);
    expect(used()).toEqual([nothing, nothing, nothing, [1, 0]]);
    publish('/a', 5);
    expect(used()).toEqual([[1, 5], nothing, nothing, nothing]);
    table.deleteValue(entry);
    entry.subscribers.delete(cleos);
    table.forgetIfUnused(entry);
    expect(used()).toEqual([nothing, nothing, nothing, nothing]);
  });

  it('tells what changed since, and what is gone [EX-11]', () => {
    const { table, publish, changesSince } = createTable();
    publish('/a');
    const gone = publish('/b');
    const first = changesSince(0);
    expect(first).toMatchObject({ topics: ['/a', '/b'], removed: [], isReset: true });
    publish('/a');
    table.deleteValue(gone);
    const second = changesSince(first.next);
    expect(second).toMatchObject({ topics: ['/a'], removed: ['/b'], isReset: false });
    expect(changesSince(second.next)).toMatchObject({ topics: [], removed: [] });
    // Another reader has an older cursor.
    expect(changesSince(first.next)).toMatchObject({ topics: ['/a'], removed: ['/b'] });
  });

  it('does not call removed what is there again [EX-11]', () => {
    const { table, publish, changesSince } = createTable();
    const entry = publish('/a');
    const { next } = changesSince(0);
    table.deleteValue(entry);
    publish('/a');
    expect(changesSince(next)).toMatchObject({ topics: ['/a'], removed: [] });
  });

  it.each([0, FIRST_EPOCH - 1, FIRST_EPOCH + 100, -1, Number.NaN, Number.POSITIVE_INFINITY])(
    'gives everything for the cursor %d, which it never gave [EX-12]',
    (cursor) => {
      const { publish, changesSince } = createTable();
      publish('/a');
      expect(changesSince(cursor)).toMatchObject({ topics: ['/a'], isReset: true });
    },
  );

  it('returns the full list to clients that ask too rarely to get the deletions [EX-12]', () => {
    const { table, publish, changesSince } = createTable(3);
    const { next: early } = changesSince(0);
    for (let i = 0; i < 6; i++) table.deleteValue(publish(`/gone/${i}`));
    const { next: late, removed } = changesSince(early);
    expect(removed).toHaveLength(6);
    table.deleteValue(publish('/gone/6'));
    expect(changesSince(early)).toMatchObject({ isReset: true, removed: [] });
    expect(changesSince(late)).toMatchObject({ isReset: false, removed: ['/gone/6'] });
  });
});
