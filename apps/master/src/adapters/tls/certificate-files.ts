import { mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';

import { ConfigError } from '@ubii/program';
import type { Issued } from './issue-certificates.ts';

/** Where a certificate and its key are kept. */
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
  mkdirSync(dirname(files.key), { recursive: true, mode: 0o700 });
  replace(files.key, issued.key, 0o600);
  replace(files.certificate, issued.certificate, 0o644);
}

/** As a whole or not at all. */
function replace(file: string, text: string, mode: number): void {
  const draft = `${file}.${process.pid}.tmp`;
  rmSync(draft, { force: true });
  writeFileSync(draft, text, { mode, flag: 'wx' });
  renameSync(draft, file);
}
