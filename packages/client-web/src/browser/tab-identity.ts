import type { Identity } from '../core/connection/identity.ts';
import type { IdentityStorage } from '../core/ports/identity-storage.ts';
import { claimIdentity } from './identity-claim.ts';
import type { Release } from './identity-claim.ts';

const DEFAULT_KEY = 'ubii.identity';

/**
 * Keeps the identity in the tab's session storage: a reload comes back as the same client. A
 * duplicated tab has a copy of that storage; it finds the identity claimed and gets one of its own.
 * Without session storage the identity lasts as long as the page.
 * The credential is kept for the whole browser as well: a further tab joins with it. [AC-23]
 * @param key name of the entry; one for each client of a page
 * @param browserKey name of the entry of the whole browser; pages that share it join with one credential
 */
export function createTabIdentity(key = DEFAULT_KEY, browserKey = key): IdentityStorage {
  const credentialKey = `${browserKey}.credential`;
  let claimedId: string | undefined;
  let release: Release = () => undefined;
  const claim = async (clientId: string): Promise<boolean> => {
    claimedId = clientId;
    const claimed = await claimIdentity(clientId);
    if (claimed === undefined) return false;
    if (claimedId === clientId) release = claimed;
    else claimed(); // given up meanwhile
    return true;
  };
  return {
    async load() {
      const identity = parseIdentity(readEntry(key));
      if (identity === undefined || !(await claim(identity.clientId))) return undefined;
      return identity;
    },
    save(identity) {
      writeEntry(key, identity === undefined ? undefined : JSON.stringify(identity));
      const credential = identity?.credential;
      if (credential !== undefined) withLocal((local) => local.setItem(credentialKey, credential));
      if (identity?.clientId === claimedId) return;
      release();
      release = () => undefined;
      claimedId = undefined;
      // No other page can hold an id that was just assigned, so that this does not fail.
      if (identity !== undefined) void claim(identity.clientId);
    },
    loadCredential: () => withLocal((local) => local.getItem(credentialKey)) ?? undefined,
    forgetCredential(credential) {
      withLocal((local) => {
        if (local.getItem(credentialKey) === credential) local.removeItem(credentialKey);
      });
    },
  };
}

function parseIdentity(text: string | undefined): Identity | undefined {
  if (text === undefined) return undefined;
  try {
    const parsed = JSON.parse(text) as Partial<Record<keyof Identity, unknown>>;
    const { clientId, resumeToken, credential } = parsed;
    if (typeof clientId !== 'string' || clientId === '') return undefined;
    return {
      clientId,
      resumeToken: typeof resumeToken === 'string' ? resumeToken : undefined,
      ...(typeof credential === 'string' ? { credential } : {}),
    };
  } catch {
    return undefined; // written by something else
  }
}

// A browser that blocks storage throws at the mere mention of it.

function withLocal<R>(use: (local: Storage) => R): R | undefined {
  try {
    return use(localStorage);
  } catch {
    return undefined;
  }
}

function readEntry(key: string): string | undefined {
  try {
    return sessionStorage.getItem(key) ?? undefined;
  } catch {
    return undefined;
  }
}

function writeEntry(key: string, text: string | undefined): void {
  try {
    if (text === undefined) sessionStorage.removeItem(key);
    else sessionStorage.setItem(key, text);
  } catch {
    // The identity then lasts as long as the page.
  }
}
