import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { OwnerStore } from '../../core/ports/owner-store.ts';
import { Inbox } from './inbox.ts';

/** Owners that several masters may open, and hands that take them away. */
export interface OwnerBench {
  /** The store of one more master. */
  readonly open: () => Promise<OwnerStore>;
  /** Takes the store that was opened first away from its master, or gives it back. */
  readonly setFirstReachable: (isReachable: boolean) => Promise<void>;
  readonly close: () => Promise<void>;
}

/** Keys as the core has them: a kind, and a UUID or a name of any characters. */
const KEYS = ['session:0a7d3f0e-5a53-4d6c-9f3c-111111111111', 'a b/c.*>', 'Füße 日本 🙂', ''];

/** Acceptance tests of stores of owners. [CU-55] */
export function ownerStoreSuite(name: string, openBench: () => Promise<OwnerBench>): void {
  describe(`${name}, an OwnerStore`, () => {
    let bench: OwnerBench;
    let first: OwnerStore;
    let second: OwnerStore;
    beforeEach(async () => {
      bench = await openBench();
      first = await bench.open();
      second = await bench.open();
    });
    afterEach(async () => {
      first.close();
      second.close();
      await bench.close();
    });

    /** Until this store knows the owner of a key. */
    const heard = async (store: OwnerStore, key: string, owner: string | undefined) => {
      const changes = new Inbox<readonly string[]>();
      const cancel = store.onChange((keys) => changes.add(keys));
      while (store.owners().get(key) !== owner) await changes.next();
      cancel();
    };

    it('begins empty', () => {
      expect(first.owners().size).toBe(0);
    });

    it.each(KEYS)('gives %j to the first that claims it, and tells the other', async (key) => {
      expect(await first.claim(key, 'A', undefined)).toBe(true);
      expect(first.owners().get(key)).toBe('A');
      expect(await second.claim(key, 'B', undefined)).toBe(false);
      await heard(second, key, 'A');
      expect([...second.owners()]).toEqual([[key, 'A']]);
    });

    it('has one winner when both claim at once', async () => {
      for (let n = 0; n < 20; n += 1) {
        const won = await Promise.all([
          first.claim(`key ${n}`, 'A', undefined),
          second.claim(`key ${n}`, 'B', undefined),
        ]);
        expect(won.filter(Boolean)).toHaveLength(1);
        const owner = won[0] ? 'A' : 'B';
        await Promise.all([heard(first, `key ${n}`, owner), heard(second, `key ${n}`, owner)]);
      }
    });

    it('lets another master take over from the owner it names, and from no other', async () => {
      await first.claim('key', 'A', undefined);
      expect(await second.claim('key', 'C', 'B')).toBe(false);
      expect(await second.claim('key', 'B', 'A')).toBe(true);
      expect(await first.claim('key', 'C', 'A')).toBe(false);
      await heard(first, 'key', 'B');
    });

    it('takes the claim of its owner again', async () => {
      expect(await first.claim('key', 'A', undefined)).toBe(true);
      expect(await first.claim('key', 'A', undefined)).toBe(true);
    });

    it('lets only the owner release a key', async () => {
      await first.claim('key', 'A', undefined);
      await second.release('key', 'B');
      await second.release('other', 'B');
      expect(first.owners().get('key')).toBe('A');
      await first.release('key', 'A');
      expect(first.owners().has('key')).toBe(false);
      await heard(second, 'key', undefined);
      expect(await second.claim('key', 'B', undefined)).toBe(true);
      await heard(first, 'key', 'B');
    });

    it('gives another map after a change, and the same one until then', async () => {
      const before = first.owners();
      expect(first.owners()).toBe(before);
      await first.claim('key', 'A', undefined);
      expect(first.owners()).not.toBe(before);
      expect(before.size).toBe(0);
    });

    it('tells its own changes, and none after it is cancelled', async () => {
      const told: string[] = [];
      const cancel = first.onChange((keys) => told.push(...keys));
      await first.claim('key', 'A', undefined);
      await first.release('key', 'A');
      cancel();
      await first.claim('other', 'A', undefined);
      expect(told).toEqual(['key', 'key']);
    });

    it('keeps what was claimed for masters that come later', async () => {
      await first.claim('key', 'A', undefined);
      const third = await bench.open();
      expect(third.owners().get('key')).toBe('A');
      third.close();
    });

    it('rejects with a reason while it is away, and then knows what happened', async () => {
      await first.claim('key', 'A', undefined);
      await bench.setFirstReachable(false);
      await expect(first.claim('other', 'A', undefined)).rejects.toThrow(/cannot be reached/);
      await expect(first.release('key', 'A')).rejects.toThrow(/cannot be reached/);
      await second.claim('key', 'B', 'A');
      await second.claim('more', 'B', undefined);
      await second.release('more', 'B');
      await bench.setFirstReachable(true);
      await heard(first, 'key', 'B');
      expect([...first.owners()]).toEqual([['key', 'B']]);
    });
  });
}
