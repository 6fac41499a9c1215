import type { IdentityStorage } from './ports/identity-storage.ts';

/** What a client needs to come back as itself. */
export interface Identity {
  /** The id the master gave. */
  readonly clientId: string;
  /** Proof that the id is ours; a secret. `undefined` with an original master. [EX-3] */
  readonly resumeToken: string | undefined;
  /** Secret of a joined client. `undefined` when the client does not need to join. [AC-13] */
  readonly credential?: string | undefined;
}

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
