import { readFileSync } from 'node:fs';

import { ConfigError, SECRET_MODE, writeAtomicallySync } from '@ubii/program';
import type { Issued } from './issue-certificates.ts';

/** Files of a certificate and its key. */
export interface CertificateFiles {
  readonly certificate: string;
  readonly key: string;
}

/** @returns undefined when one of the two is not there */
export function readCertificate({ certificate, key }: CertificateFiles): Issued | undefined {
  try {
    return { certificate: readFileSync(certificate, 'utf8'), key: readFileSync(key, 'utf8') };
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    if (code === 'ENOENT') return undefined;
    throw new ConfigError(`A certificate cannot be read: ${message}.`);
  }
}

/** Writes both; the key is its owner's alone. */
export function writeCertificate(files: CertificateFiles, issued: Issued): void {
  writeAtomicallySync(files.key, issued.key, SECRET_MODE);
  writeAtomicallySync(files.certificate, issued.certificate, 0o644);
}
