import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it } from 'vitest';

import { parseCluster } from '../config/cluster-address.ts';
import { readAuthorities, readCredentials } from './credentials.ts';

const PLAIN = parseCluster('nats://a');

function fileWith(text: string): string {
  const file = join(temporaryFolder(), 'nats.creds');
  writeFileSync(file, text);
  return file;
}

describe('[CU-62] what a master identifies itself with', () => {
  it('is nothing by default', () => {
    expect(readCredentials(undefined, PLAIN)).toBeUndefined();
  });

  it('is in the address', () => {
    const login = (url: string) => readCredentials(undefined, parseCluster(url))?.();
    expect(login('nats://ann:secret@a')).toEqual({ user: 'ann', pass: 'secret' });
    expect(login('nats://t0ken@a')).toEqual({ auth_token: 't0ken' });
  });

  it('is a line of a file', () => {
    const login = (text: string) => readCredentials(fileWith(text), PLAIN)?.();
    expect(login('ann:se:cret\n')).toEqual({ user: 'ann', pass: 'se:cret' });
    expect(login('t0ken\n')).toEqual({ auth_token: 't0ken' });
  });

  it('is a .creds file, with a signature', () => {
    // A seed of the documentation of NATS, not used anywhere.
    const seed = 'SUAEL6GG2L2HIF7DUGZJGMRUFKXELGGYFMHF76UO2AYBG3K4YLWR3FKC2Q';
    const file = fileWith(
      `-----BEGIN NATS USER JWT-----\neyJ0.eyJq.c2ln\n------END NATS USER JWT------\n\n-----BEGIN USER NKEY SEED-----\n${seed}\n------END USER NKEY SEED------\n`,
    );
    expect(readCredentials(file, PLAIN)?.('nonce')).toMatchObject({
      jwt: 'eyJ0.eyJq.c2ln',
      nkey: expect.stringMatching(/^U/),
      sig: expect.stringMatching(/./),
    });
  });

  it.each(['', 'two\nlines', '-----BEGIN NATS USER JWT-----\nx\n'])(
    'is not a file with %j, and the error shows no secret',
    (text) => {
      const file = fileWith(text);
      expect(() => readCredentials(file, PLAIN)).toThrow(/--cluster-credentials/);
    },
  );

  it('is asked for when its file is missing, as the authorities are', () => {
    expect(() => readCredentials('/nowhere/x', PLAIN)).toThrow(/cannot be read.*ENOENT/);
    expect(() => readAuthorities('/nowhere/x')).toThrow(/--cluster-ca cannot be read.*ENOENT/);
    expect(() => readAuthorities(fileWith('x'))).toThrow(/has no certificate/);
  });
});
