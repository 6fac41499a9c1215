import { X509Certificate } from 'node:crypto';
import { readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { beforeEach, describe, expect, it } from 'vitest';

import { ConfigError } from '@ubii/program';
import { temporaryFolder } from '@ubii/program/testing';
import { Certificates } from './certificates.ts';
import type { CertificatesOptions } from './certificates.ts';

const DAY_MS = 24 * 60 * 60 * 1000;
const HOME = ['localhost', 'lab', 'lab.local', '127.0.0.1', '::1', '192.168.1.7', 'fd00::7'];

let dataDir: string;
let warnings: string[];
beforeEach(() => {
  dataDir = temporaryFolder();
  warnings = [];
});

function open(given: Partial<CertificatesOptions> = {}): Promise<Certificates> {
  const log = {
    error: () => {},
    warn: (text: string) => warnings.push(text),
    info: () => {},
    debug: () => {},
    child: () => log,
  };
  return Certificates.open({
    dataDir,
    own: undefined,
    names: () => HOME,
    masterName: 'lab',
    nowMs: Date.now,
    log,
    ...given,
  });
}

const leafOf = ({ served }: Certificates): X509Certificate =>
  new X509Certificate(served.certificate);
const authorityOf = ({ authority }: Certificates): X509Certificate =>
  new X509Certificate(authority!);
const file = (name: string): string => join(dataDir, 'tls', name);

describe('the certificates of a master', () => {
  it('are made at the first start, for every name and address of the machine', async () => {
    const certificates = await open();
    const leaf = leafOf(certificates);
    const authority = authorityOf(certificates);
    expect(authority.ca).toBe(true);
    expect(authority.subject).toContain('Ubi-Interact lab');
    expect(leaf.ca).toBe(false);
    expect(leaf.verify(authority.publicKey)).toBe(true);
    expect(leaf.checkHost('localhost')).toBeDefined();
    expect(leaf.checkHost('lab.local')).toBeDefined();
    for (const address of ['127.0.0.1', '::1', '192.168.1.7', 'fd00::7']) {
      expect(leaf.checkIP(address)).toBeDefined();
    }
    const days = (Date.parse(leaf.validTo) - Date.parse(leaf.validFrom)) / DAY_MS;
    expect(days).toBeLessThanOrEqual(397);
    expect(warnings).toEqual([]);
  });

  it.skipIf(process.platform === 'win32')('have keys that only their owner reads', async () => {
    await open();
    expect(statSync(file('authority.key')).mode & 0o777).toBe(0o600);
    expect(statSync(file('leaf.key')).mode & 0o777).toBe(0o600);
  });

  it('are the same at the next start', async () => {
    const first = await open();
    const second = await open();
    expect(second.served).toEqual(first.served);
    expect(second.authority).toBe(first.authority);
  });

  it('get a new leaf of the same authority when the machine gets an address', async () => {
    let names = HOME;
    const certificates = await open({ names: () => names });
    const before = certificates.served;
    expect(await certificates.renewIfNeeded()).toBe(false);
    names = [...HOME, '10.1.2.3'];
    expect(await certificates.renewIfNeeded()).toBe(true);
    expect(certificates.served).not.toEqual(before);
    expect(leafOf(certificates).checkIP('10.1.2.3')).toBeDefined();
    expect(leafOf(certificates).verify(authorityOf(certificates).publicKey)).toBe(true);
    names = HOME;
    expect(await certificates.renewIfNeeded()).toBe(false);
    expect((await open({ names: () => [...HOME, '10.1.2.3'] })).served).toEqual(
      certificates.served,
    );
  });

  it('get a new leaf before the old one ends', async () => {
    let nowMs = Date.now();
    const certificates = await open({ nowMs: () => nowMs });
    nowMs += 300 * DAY_MS;
    expect(await certificates.renewIfNeeded()).toBe(false);
    nowMs += 70 * DAY_MS;
    expect(await certificates.renewIfNeeded()).toBe(true);
    expect(Date.parse(leafOf(certificates).validTo)).toBeGreaterThan(nowMs + 300 * DAY_MS);
  });

  it('leave out a public address that came after the authority was made, once, and say so', async () => {
    let names = HOME;
    const certificates = await open({ names: () => names });
    names = [...HOME, '203.0.113.9', '10.0.0.9'];
    expect(await certificates.renewIfNeeded()).toBe(true);
    expect(leafOf(certificates).checkIP('203.0.113.9')).toBeUndefined();
    expect(leafOf(certificates).checkIP('10.0.0.9')).toBeDefined();
    expect(warnings).toEqual([expect.stringContaining('203.0.113.9')]);
    expect(await certificates.renewIfNeeded()).toBe(false);
  });

  it('are good for a public address that the machine had when the authority was made', async () => {
    const certificates = await open({ names: () => [...HOME, '203.0.113.9', '2001:db8::9'] });
    expect(leafOf(certificates).checkIP('203.0.113.9')).toBeDefined();
    expect(leafOf(certificates).checkIP('2001:db8::9')).toBeDefined();
    expect(warnings).toEqual([]);
  });

  it('are those of the operator, when there are files', async () => {
    const made = await open();
    const own = { certificate: file('leaf.pem'), key: file('leaf.key') };
    const certificates = await open({ own, dataDir: join(dataDir, 'other') });
    expect(certificates.served).toEqual(made.served);
    expect(certificates.authority).toBeUndefined();
    expect(await certificates.renewIfNeeded()).toBe(false);
  });

  it('that are missing or do not go together are named with what to do', async () => {
    const missing = { certificate: '/no/where.pem', key: '/no/where.key' };
    await expect(open({ own: missing })).rejects.toThrow(ConfigError);
    await open();
    const mixed = { certificate: file('leaf.pem'), key: file('authority.key') };
    await expect(open({ own: mixed })).rejects.toThrow(/cannot be used.*both as PEM/);
    writeFileSync(file('authority.key'), 'damaged');
    await expect(open()).rejects.toThrow(
      /authority\.key\. The master then creates another authority/,
    );
  });

  it('are repaired when the leaf is damaged', async () => {
    const first = await open();
    writeFileSync(file('leaf.pem'), 'damaged');
    const second = await open();
    expect(second.authority).toBe(first.authority);
    expect(readFileSync(file('leaf.pem'), 'utf8')).toBe(second.served.certificate);
    expect(leafOf(second).verify(authorityOf(second).publicKey)).toBe(true);
  });
});
