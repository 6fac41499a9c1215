import type { Identity, IdentityStorage } from '../ports/identity-storage.ts';
export type { Identity } from '../ports/identity-storage.ts';

/** Keeps the identity as long as the program runs: the default. */
export function createMemoryIdentity(initial?: Identity): IdentityStorage {
  let identity = initial;
  return {
    load: () => identity,
    save(next) {
      identity = next;
    },
  };
}
