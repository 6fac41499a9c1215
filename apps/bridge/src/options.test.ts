import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ConfigError, flagName, formatHelp, readOptions } from '@ubii/program';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it } from 'vitest';
import { readAuthority, readCredentials } from './credentials.ts';
import { BRIDGE_PROGRAM, OPTIONS, parseTarget } from './options.ts';
import { openMappingStore } from './open-mapping-store.ts';

describe('the configuration of a bridge', () => {
  it('takes the address as a word, and flags before the environment', () => {
    const read = readOptions(
      BRIDGE_PROGRAM,
      ['mqtt://localhost', '--mapping', 'hall.json', '--name', 'hall'],
      { UBII_BRIDGE_NAME: 'kitchen', UBII_BRIDGE_CA: 'ca.pem' },
      '/home/ada',
    );
    expect(read.words).toEqual(['mqtt://localhost']);
    expect(read.values).toMatchObject({
      mapping: '/home/ada/hall.json',
      name: 'hall',
      ca: '/home/ada/ca.pem',
      protocol: undefined,
      master: 'http://localhost:8080',
    });
  });

  it.each([
    ['mqtt://broker', undefined, 'mqtt', 'mqtt://broker:1883', 'mqtt broker:1883'],
    ['mqtts://broker', undefined, 'mqtt', 'mqtts://broker:8883', 'mqtt broker:8883'],
    ['osc://10.0.0.2:7000', 'osc', 'osc', 'osc://10.0.0.2:7000', 'osc 10.0.0.2:7000'],
    ['rosbridge://robot', undefined, 'rosbridge', 'ws://robot:9090', 'rosbridge robot:9090'],
    [
      'ws://robot:9091/ros',
      'rosbridge',
      'rosbridge',
      'ws://robot:9091/ros',
      'rosbridge robot:9091',
    ],
  ] as const)('%s (%s) is %s at %s', (text, protocol, expected, url, system) => {
    expect(parseTarget([text], protocol)).toMatchObject({ protocol: expected, url, system });
  });

  it.each([
    [[], undefined, 'Give the address of one other system'],
    [['mqtt://a', 'mqtt://b'], undefined, 'Give the address of one other system'],
    [['http://x'], undefined, 'must be like mqtt://localhost:1883'],
    [['mqtt://x'], 'osc', 'is for mqtt, but --protocol says osc'],
    [['mqtt://ada:secret@x'], undefined, 'must not have a user or a password'],
  ] as const)('refuses the address %j (%s)', (words, protocol, reason) => {
    const parse = () => parseTarget(words, protocol);
    expect(parse).toThrow(ConfigError);
    expect(parse).toThrow(reason);
    expect(parse).not.toThrow('secret');
  });

  it('reads user and password from a file or the environment [BR-43]', () => {
    const file = join(temporaryFolder(), 'credentials');
    writeFileSync(file, 'ada\r\nsecret\r\n');
    expect(readCredentials(file, {})).toEqual({ user: 'ada', password: 'secret' });
    const env = { UBII_BRIDGE_USER: 'ben', UBII_BRIDGE_PASSWORD: 'word' };
    expect(readCredentials(undefined, env)).toEqual({ user: 'ben', password: 'word' });
    expect(readCredentials(undefined, {})).toEqual({ user: undefined, password: undefined });
    writeFileSync(file, '\nsecret');
    expect(() => readCredentials(file, {})).toThrow('must have the user in its first line');
    expect(() => readCredentials('/nowhere', {})).toThrow('it does not exist');
    expect(() => readAuthority(file)).toThrow('must contain a certificate in PEM');
  });

  it('shows an example when there is no mapping file, and the file when it is wrong [BR-1]', () => {
    expect(() => openMappingStore('/nowhere.json', 'mqtt')).toThrow(
      /does not exist. Create it[^]*"version": 1/,
    );
    const file = join(temporaryFolder(), 'bridge.json');
    writeFileSync(file, '{"version":1}');
    expect(() => openMappingStore(file, 'mqtt')).toThrow(`${file}: mappings is missing.`);
  });

  it('lists every option in the help', () => {
    const help = formatHelp(BRIDGE_PROGRAM);
    for (const name of Object.keys(OPTIONS)) expect(help).toContain(`  ${flagName(name)}`);
    for (const line of help.split('\n')) expect(line.length).toBeLessThanOrEqual(96);
  });
});
