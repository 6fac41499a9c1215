import { readFileSync } from 'node:fs';
import {
  credsAuthenticator,
  tokenAuthenticator,
  usernamePasswordAuthenticator,
  type Authenticator,
} from '@nats-io/transport-node';
import { ConfigError } from '@ubii/program';

import type { ClusterAddress } from '../config/cluster-address.ts';

/**
 * What a master identifies itself with at a NATS server: from a file, or from the address. [CU-62]
 *
 * @param file as `nsc` writes it (`.creds`), or one line: `user:password`, or a token
 * @throws ConfigError when the file cannot be read or is empty
 */
export function readCredentials(
  file: string | undefined,
  { login }: ClusterAddress,
): Authenticator | undefined {
  if (file !== undefined) return fromFile(file);
  if (login === undefined) return undefined;
  return 'token' in login
    ? tokenAuthenticator(login.token)
    : usernamePasswordAuthenticator(login.user, login.password);
}

function fromFile(file: string): Authenticator {
  const text = read(file, '--cluster-credentials');
  if (text.startsWith('-----BEGIN')) return checked(file, text);
  if (text === '' || text.includes('\n')) {
    throw new ConfigError(
      `The file ${file} of --cluster-credentials must be a .creds file, or one line with user:password or a token.`,
    );
  }
  const colon = text.indexOf(':');
  if (colon < 0) return tokenAuthenticator(text);
  return usernamePasswordAuthenticator(text.slice(0, colon), text.slice(colon + 1));
}

/** Checked at the start: the library reads the file at each connection, and its error would not be reported. */
function checked(file: string, text: string): Authenticator {
  const authenticator = credsAuthenticator(Buffer.from(`${text}\n`));
  try {
    authenticator('nonce');
  } catch {
    throw new ConfigError(
      `The file ${file} of --cluster-credentials has no valid user JWT and seed. Export it again with nsc.`,
    );
  }
  return authenticator;
}

/** The certificates that those of the servers are checked with, PEM. @throws ConfigError when they cannot be read */
export function readAuthorities(file: string): string {
  const text = read(file, '--cluster-ca');
  if (text.includes('-----BEGIN CERTIFICATE-----')) return text;
  throw new ConfigError(`The file ${file} of --cluster-ca has no certificate. It must be PEM.`);
}

function read(file: string, flag: string): string {
  try {
    return readFileSync(file, 'utf8').trim();
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new ConfigError(`The file of ${flag} cannot be read: ${reason}`);
  }
}
