import { readFileSync } from 'node:fs';
import { ConfigError } from '@ubii/program';
import type { Environment } from '@ubii/program';
import type { Protocol } from './core/mapping/mapping.ts';

/** User and password at the other system. */
export interface Credentials {
  readonly user: string | undefined;
  readonly password: string | undefined;
}

/**
 * Reads user and password from a file or the environment. They are in no flag, and in no message. [BR-43]
 *
 * @throws ConfigError when the file cannot be read
 */
export function readCredentials(file: string | undefined, env: Environment): Credentials {
  if (file === undefined) {
    return {
      user: env['UBII_BRIDGE_USER'] || undefined,
      password: env['UBII_BRIDGE_PASSWORD'] || undefined,
    };
  }
  const [user = '', password = ''] = read(file, '--credentials-file').toString().split(/\r?\n/);
  if (user === '') {
    throw new ConfigError(
      `The file ${file} (--credentials-file) must have the user in its first line and the password in its second.`,
    );
  }
  return { user, password: password === '' ? undefined : password };
}

/** @throws ConfigError when a system without users gets some: who gives a password believes that it protects. [BR-43] */
export function checkCredentials(protocol: Protocol, { user, password }: Credentials): void {
  if (protocol !== 'osc' || (user === undefined && password === undefined)) return;
  throw new ConfigError(
    'OSC has no users and no passwords. Leave out --credentials-file, UBII_BRIDGE_USER and UBII_BRIDGE_PASSWORD.',
  );
}

/** @throws ConfigError when the file cannot be read or has no certificate */
export function readAuthority(file: string | undefined): Buffer | undefined {
  if (file === undefined) return undefined;
  const content = read(file, '--ca');
  if (content.includes('-----BEGIN CERTIFICATE-----')) return content;
  throw new ConfigError(`The file ${file} (--ca) must contain a certificate in PEM.`);
}

function read(file: string, flag: string): Buffer {
  try {
    return readFileSync(file);
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    const reason =
      code === 'ENOENT'
        ? 'it does not exist'
        : code === 'EACCES'
          ? 'this user may not read it'
          : message;
    throw new ConfigError(`The file ${file} (${flag}) cannot be read: ${reason}.`);
  }
}
