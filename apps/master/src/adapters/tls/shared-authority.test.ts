import { X509Certificate } from 'node:crypto';
import { chmodSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { ConfigError } from '@ubii/program';
import { temporaryFolder } from '@ubii/program/testing';
import { beforeEach, describe, expect, it } from 'vitest';

import { Certificates } from './certificates.ts';

let shared: string;
let warnings: string[];
beforeEach(() => {
  shared = join(temporaryFolder(), 'keys', 'authority.pem');
  warnings = [];
});

/** A master on a machine with this address. */
async function open(address: string, dataDir = temporaryFolder()) {
  const log = {
    error: () => {},
    warn: (text: string) => warnings.push(text),
    info: () => {},
    debug: () => {},
    child: () => log,
  };
  const certificates = await Certificates.open({
    dataDir,
    own: undefined,
    sharedAuthority: shared,
    names: () => ['localhost', '127.0.0.1', address],
    masterName: 'lab',
    nowMs: Date.now,
    log,
  });
  return { certificates, leaf: new X509Certificate(certificates.served.certificate) };
}

describe('masters that are given the same authority [CU-94]', () => {
  it('have certificates of their own, which clients that trust one of them accept', async () => {
    const [a, b] = [await open('10.0.0.5'), await open('10.0.0.6')];
    expect(b.certificates.authority).toBe(a.certificates.authority);
    expect(a.leaf.checkIP('10.0.0.5') && b.leaf.checkIP('10.0.0.6')).toBeDefined();
    expect(a.leaf.checkIP('10.0.0.6')).toBeUndefined();
    const { publicKey } = new X509Certificate(a.certificates.authority!);
    expect([a.leaf.verify(publicKey), b.leaf.verify(publicKey)]).toEqual([true, true]);
    expect(a.certificates.authority).not.toContain('PRIVATE KEY');
    expect(warnings).toEqual([]);
  });

  it('use that of the first when they start at once', async () => {
    const all = await Promise.all(['10.0.0.5', '10.0.0.6', '10.0.0.7'].map((each) => open(each)));
    expect(new Set(all.map(({ certificates }) => certificates.authority)).size).toBe(1);
  });

  it('issue again when they had an authority of their own before', async () => {
    const dataDir = temporaryFolder();
    const file = shared;
    shared = join(temporaryFolder(), 'other.pem');
    const before = await open('10.0.0.5', dataDir);
    shared = file;
    const after = await open('10.0.0.5', dataDir);
    expect(after.certificates.authority).not.toBe(before.certificates.authority);
    const { publicKey } = new X509Certificate(after.certificates.authority!);
    expect(after.leaf.verify(publicKey)).toBe(true);
  });

  it.skipIf(process.platform === 'win32')(
    'keep it for its owner, and warn when others may read it',
    async () => {
      await open('10.0.0.5');
      expect(statSync(shared).mode & 0o777).toBe(0o600);
      chmodSync(shared, 0o644);
      await open('10.0.0.6');
      expect(warnings).toEqual([expect.stringContaining('chmod 600')]);
    },
  );

  it.each([
    ['something else', () => 'damaged'],
    ['the certificate alone', (text: string) => text.replace(/-----BEGIN PRIVATE KEY[^]*$/, '')],
    [
      'a key that is not its',
      (text: string, other: string) =>
        text.replace(/-----BEGIN PRIVATE KEY[^]*$/, '') +
        /-----BEGIN PRIVATE KEY[^]*$/.exec(other)![0],
    ],
  ])('do not start with %s in the file', async (_, change) => {
    await open('10.0.0.5');
    const file = shared;
    shared = join(temporaryFolder(), 'other.pem');
    await open('10.0.0.5');
    const other = readFileSync(shared, 'utf8');
    shared = file;
    writeFileSync(shared, change(readFileSync(shared, 'utf8'), other));
    await expect(open('10.0.0.6')).rejects.toThrow(ConfigError);
  });

  it('do not start with a certificate that is no authority', async () => {
    const dataDir = temporaryFolder();
    await open('10.0.0.5', dataDir);
    const [leaf] = readFileSync(join(dataDir, 'tls/leaf.pem'), 'utf8').split(
      /(?<=-----END CERTIFICATE-----\n)/,
    );
    writeFileSync(shared, leaf! + readFileSync(join(dataDir, 'tls/leaf.key'), 'utf8'));
    await expect(open('10.0.0.6')).rejects.toThrow(/must be that of an authority/);
  });
});
