import { readFileSync, statSync } from 'node:fs';

import { ConfigError, createAtomicallySync, SECRET_MODE } from '@ubii/program';

import type { Log } from '../../core/ports/index.ts';
import type { Issued } from './issue-certificates.ts';

const PEM = /-----BEGIN ([A-Z ]+)-----[^-]+-----END \1-----/g;

/**
 * The authority that several masters share: certificate and key in one file, so that there is one thing to copy.
 *
 * @returns undefined when the file is not there
 * @throws ConfigError when it holds something else
 */
export function readSharedAuthority(file: string, log: Log): Issued | undefined {
  let text: string;
  try {
    text = readFileSync(file, 'utf8');
    warnOfReaders(file, log);
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    if (code === 'ENOENT') return undefined;
    throw new ConfigError(`The authority for HTTPS cannot be read: ${message}.`);
  }
  const blocks = [...text.matchAll(PEM)];
  const [certificate, ...more] = blocks.filter(([, kind]) => kind === 'CERTIFICATE');
  const key = blocks.find(([, kind]) => kind === 'PRIVATE KEY');
  if (certificate === undefined || key === undefined || more.length > 0) {
    throw new ConfigError(
      `The file ${file} (--tls-authority) must hold one certificate and its key (PKCS #8), both as PEM. Use a file that a master created, or one that is not there yet.`,
    );
  }
  return { certificate: `${certificate[0]}\n`, key: `${key[0]}\n` };
}

/** Writes the authority for its owner alone, unless another master was first: then it is that one's. */
export function createSharedAuthority(file: string, authority: Issued, log: Log): Issued {
  createAtomicallySync(
    file,
    `${authority.certificate.trim()}\n${authority.key.trim()}\n`,
    SECRET_MODE,
  );
  return readSharedAuthority(file, log) ?? authority;
}

function warnOfReaders(file: string, log: Log): void {
  if (process.platform === 'win32' || (statSync(file).mode & 0o077) === 0) return;
  log.warn(
    `Other users of this machine may read ${file}. With its key, a user can act as this master towards all devices that trust the authority. Allow its owner only (chmod 600).`,
  );
}
