import { homedir } from 'node:os';
import { join } from 'node:path';
import { readOptions } from '@ubii/program';
import { expect, it } from 'vitest';
import { createConfig, MASTER_PROGRAM } from './config.ts';
import { describeConfig } from './describe-config.ts';

const HOME = homedir();

function settings(...args: string[]) {
  return describeConfig(createConfig(readOptions(MASTER_PROGRAM, args, {}, HOME)), HOME);
}

function describe(...args: string[]): Record<string, string> {
  return Object.fromEntries(settings(...args).elements!.map(({ flag, value }) => [flag, value]));
}

it('[EX-50] tells every option as people write it', () => {
  const told = describe('--lan', '--legacy-ports', 'off', '--checks', 'throttle');
  expect(told).toMatchObject({
    '--port': '8080',
    '--lan': 'on',
    '--legacy-ports': 'off',
    '--zeromq-ports': 'off',
    '--modules': 'none',
    '--allowed-origins': 'none',
    '--checks': 'throttle',
    '--busy-percent': '80',
  });
  expect(told['--limits']).toBe('defaults');
  expect(told).not.toHaveProperty('--help');
});

it('[EX-50] tells limits as they were given, and refuses names of none', () => {
  expect(describe('--limits', 'clients=7, topics=9')['--limits']).toBe('clients=7, topics=9');
  expect(() => describe('--limits', 'guests=7')).toThrow(/limits by name.*"guests=7"/);
  expect(() => describe('--limits', 'clients=0')).toThrow(/at least 1/);
});

it('[EX-50] tells neither where keys lie nor whose home it is', () => {
  const told = describe(
    ...['--data-dir', join(HOME, 'ubii')],
    ...['--tls-certificate', join(HOME, 'a.pem'), '--tls-key', join(HOME, 'secret.pem')],
  );
  expect(told['--data-dir']).toBe(join('~', 'ubii'));
  expect(told['--tls-key']).toBe('given');
  expect(Object.values(told).join(' ')).not.toContain(HOME);
});

it('[EX-50] [CU-62] tells the servers of a cluster, and not its login', () => {
  const told = describe(
    ...['--cluster', 'nats://ann:secret@a,nats://ann:secret@b:4333', '--cluster-name', 'lab'],
  );
  expect(told['--cluster']).toBe('nats://a:4222, nats://b:4333');
  expect(told['--cluster-name']).toBe('lab');
  expect(Object.values(told).join(' ')).not.toContain('secret');
  const withFile = describe('--cluster', 'tls://a', '--cluster-credentials', '/etc/nats.creds');
  expect(withFile['--cluster-credentials']).toBe('given');
  expect(describe()['--cluster']).toBe('none');
});

it('[EX-50] describes the options that are set, and the machine', () => {
  const { elements, runtime } = settings('--port', '0');
  expect(elements!.filter(({ given }) => given).map(({ flag }) => flag)).toEqual(['--port']);
  expect(runtime).toContain(process.version);
});
