import { isProcessRunning, SECRET_MODE, userStateFolder, writeAtomicallySync } from '@ubii/program';
import type { Environment } from '@ubii/program';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Identity } from '../core/connection/identity.ts';
import type { IdentityStorage } from '../core/ports/identity-storage.ts';

interface Kept {
  readonly clientId: string;
  readonly resumeToken?: string;
  /** Secret of a joined client [AC-13]. */
  readonly credential?: string;
  /** The process that uses the identity, or used it last. */
  readonly pid: number;
}

/**
 * Stores the identity of a program in a file, so that its next run is the same client: a node gets the modules
 * that sessions assigned to it. [PM-63] Does not load an identity that another running process uses. The file is a
 * secret: a program that reads it can connect as this client.
 */
export function createIdentityFile(
  path: string,
  isRunning: (pid: number) => boolean = isProcessRunning,
): IdentityStorage {
  let isOurs = true;
  return {
    load(): Identity | undefined {
      const kept = read(path);
      if (kept === undefined) return undefined;
      isOurs = kept.pid === process.pid || !isRunning(kept.pid);
      if (!isOurs) return undefined;
      const { clientId, resumeToken, credential } = kept;
      return { clientId, resumeToken, ...(credential === undefined ? {} : { credential }) };
    },
    save(identity: Identity | undefined): void {
      // Keep the identity when the node deregisters: the next run needs it. An invalid one is replaced.
      if (!isOurs || identity === undefined) return;
      const kept: Kept = {
        clientId: identity.clientId,
        ...(identity.resumeToken === undefined ? {} : { resumeToken: identity.resumeToken }),
        ...(identity.credential === undefined ? {} : { credential: identity.credential }),
        pid: process.pid,
      };
      writeAtomicallySync(path, JSON.stringify(kept), SECRET_MODE);
    },
  };
}

/**
 * Returns the default path of the identity file of a program.
 *
 * @param kind folder of the programs of one kind
 */
export function defaultIdentityFile(
  kind: 'nodes' | 'bridges' | 'programs',
  master: string,
  name: string,
  env: Environment = process.env,
): string {
  const file = encodeURIComponent(`${name} at ${new URL(master).host}`);
  return join(userStateFolder(env), kind, `${file}.json`);
}

function read(path: string): Kept | undefined {
  try {
    const kept = JSON.parse(readFileSync(path, 'utf8')) as Partial<Kept> | null;
    if (typeof kept?.clientId !== 'string' || typeof kept.pid !== 'number') return undefined;
    return kept as Kept;
  } catch {
    return undefined; // missing or invalid
  }
}
