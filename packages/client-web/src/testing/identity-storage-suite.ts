import { afterEach, describe, expect, it } from 'vitest';
import type { IdentityStorage } from '../core/ports/identity-storage.ts';

/** One place where an identity is kept, and programs that use it one after the other. */
export interface IdentityStorageWorld {
  /** The storage as the next run of the program sees it; the run before is over. */
  nextRun(): IdentityStorage;
  close(): void;
}

const ADA = { clientId: 'ada-1', resumeToken: 'token' };

/** Acceptance tests of identity storages. */
export function describeIdentityStorage(name: string, setup: () => IdentityStorageWorld): void {
  describe(`${name} as an identity storage`, () => {
    let world: IdentityStorageWorld;
    const open = (): IdentityStorage => (world = setup()).nextRun();
    afterEach(() => world.close());

    it('has nothing at first', async () => {
      expect(await open().load()).toBeUndefined();
    });

    it('gives the next run what the one before saved last', async () => {
      const storage = open();
      storage.save({ clientId: 'ben', resumeToken: 'other' });
      storage.save(ADA);
      storage.save(ADA);
      expect(await world.nextRun().load()).toEqual(ADA);
      expect(await world.nextRun().load()).toEqual(ADA);
    });

    it('keeps an identity without a token', async () => {
      open().save({ clientId: 'ada-1', resumeToken: undefined });
      expect(await world.nextRun().load()).toEqual({ clientId: 'ada-1', resumeToken: undefined });
    });

    it('forgets', async () => {
      const storage = open();
      storage.save(ADA);
      storage.save(undefined);
      expect(await world.nextRun().load()).toBeUndefined();
    });
  });
}
