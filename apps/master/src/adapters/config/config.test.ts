import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ConfigError, environmentName, flagName, formatHelp, readOptions } from '@ubii/program';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it } from 'vitest';

import { createConfig, MASTER_PROGRAM, OPTIONS } from './config.ts';
import type { OptionName } from './config.ts';

const names = Object.keys(OPTIONS) as OptionName[];

function resolve(args: readonly string[], env: Record<string, string> = {}) {
  return createConfig(readOptions(MASTER_PROGRAM, args, env, '/work-folder'));
}

function messageOf(args: readonly string[], env: Record<string, string> = {}): string {
  try {
    resolve(args, env);
  } catch (error) {
    expect(error).toBeInstanceOf(ConfigError);
    return (error as ConfigError).message;
  }
  throw new Error('no error was thrown');
}

function configFile(content: unknown): string {
  const file = join(temporaryFolder(), 'ubii.json');
  writeFileSync(file, typeof content === 'string' ? content : JSON.stringify(content));
  return file;
}

describe('options', () => {
  it('have the documented fallbacks', () => {
    const config = resolve([]);
    expect(config).toMatchObject({
      port: 8080,
      host: 'localhost',
      lan: true,
      legacyPorts: { services: 8102, topicData: 8104 },
      allowedOrigins: [],
      printEndpoints: undefined,
      checks: 'warn',
      busyPercent: 80,
      publisherPercent: 40,
      logLevel: 'info',
      logFormat: 'auto',
    });
    expect(config.given.size).toBe(0);
  });

  it('are named alike as flag, variable and key', () => {
    expect(flagName('dataDir')).toBe('--data-dir');
    expect(environmentName('UBII_', 'legacyPorts')).toBe('UBII_LEGACY_PORTS');
  });

  it('are all in the help, with flag, variable and key', () => {
    const help = formatHelp(MASTER_PROGRAM);
    for (const name of names) {
      expect(help).toContain(flagName(name));
      expect(help).toContain(environmentName('UBII_', name));
      expect(help).toContain(`"${name}"`);
    }
  });

  it('come from the flag before the environment before the file', () => {
    const file = configFile({ port: 1, name: 'from the file', logLevel: 'error' });
    const config = resolve(['--port', '3', '--config', file], { UBII_PORT: '2', UBII_NAME: 'env' });
    expect(config).toMatchObject({ port: 3, name: 'env', logLevel: 'error' });
    expect([...config.given].sort()).toEqual(['config', 'logLevel', 'name', 'port']);
  });

  it('may be written --flag=value', () => {
    expect(resolve(['--port=0', '--allowed-origins=http://a.b:1']).port).toBe(0);
  });

  it('take switches without a value', () => {
    expect(resolve(['--lan', '--port', '1']).lan).toBe(true);
    expect(resolve(['--lan=false']).lan).toBe(false);
    expect(resolve(['--lan', 'off', '--port', '1'])).toMatchObject({ lan: false, port: 1 });
    expect(resolve(['--lan', 'on', '--port', '1'])).toMatchObject({ lan: true, port: 1 });
    expect(resolve(['--host', '10.0.0.7']).lan).toBe(false);
    expect(resolve(['--lan', 'off', '--host', '10.0.0.7']).host).toBe('10.0.0.7');
    expect(resolve([], { UBII_LAN: 'on' }).lan).toBe(true);
  });

  it('take the public address as an origin [SV-13]', () => {
    expect(resolve(['--public-url', 'https://Ubii.example.org:443/']).publicUrl).toBe(
      'https://ubii.example.org',
    );
  });

  it('take relative paths from where they were written', () => {
    expect(resolve(['--data-dir', 'x']).dataDir).toBe('/work-folder/x');
    const file = configFile({ dataDir: 'x' });
    expect(resolve(['--config', file]).dataDir).toBe(join(file, '..', 'x'));
  });

  it('take lists, numbers and switches in the file', () => {
    const file = configFile({
      port: 9000,
      lan: true,
      legacyPorts: [1, 2],
      allowedOrigins: ['http://a', 'https://*.b:*'],
      name: null,
    });
    expect(resolve([], { UBII_CONFIG: file })).toMatchObject({
      port: 9000,
      lan: true,
      legacyPorts: { services: 1, topicData: 2 },
      allowedOrigins: ['http://a', 'https://*.b:*'],
    });
  });
});

describe('legacy ports', () => {
  it.each([
    ['on', { services: 8102, topicData: 8104 }],
    ['off', undefined],
    ['9000,9001', { services: 9000, topicData: 9001 }],
    ['0, 0', { services: 0, topicData: 0 }],
  ])('%s', (text, expected) => {
    const config = resolve(['--legacy-ports', text]);
    expect(config.legacyPorts).toEqual(expected);
    expect(config.given.has('legacyPorts')).toBe(true);
  });
});

describe('ports of ZeroMQ [SV-62]', () => {
  it.each([
    [[], undefined],
    [['--zeromq-ports', 'off'], undefined],
    [['--zeromq-ports', 'on'], { services: 8101, topicData: 8103 }],
    [['--zeromq-ports', '0,0'], { services: 0, topicData: 0 }],
  ])('%j', (flags, expected) => {
    expect(resolve(flags).zeromqPorts).toEqual(expected);
  });
});

describe('a wrong value is explained in one sentence', () => {
  it.each([
    [['--port', 'abc'], '--port must be a whole number from 0 to 65535'],
    [['--port', '65536'], 'but is "65536" on the command line'],
    [['--port', '-1'], '"-1"'],
    [['--port', '80.5'], '"80.5"'],
    [['--port', ''], '""'],
    [['--host', 'http://x'], 'without scheme and port'],
    [['--public-url', 'ubii.example.org'], 'an address without a path'],
    [['--public-url', 'https://ubii.example.org/lab'], 'an address without a path'],
    [['--public-url', 'https://user:word@ubii.example.org'], 'an address without a path'],
    [['--public-url', 'ftp://ubii.example.org'], 'an address without a path'],
    [['--lan=maybe'], 'true or false'],
    [['--legacy-ports', '8102'], 'two ports separated by a comma'],
    [['--legacy-ports', '1,2,3'], 'on, off, or two ports'],
    [['--zeromq-ports', '1'], 'two ports separated by a comma, such as 8101,8103'],
    [['--zeromq-ports', '8101,8102'], 'Port 8102 of --zeromq-ports cannot be used for anything'],
    [['--zeromq-ports', '9000,9000'], 'Port 9000 of --zeromq-ports'],
    [['--print-endpoints', 'xml'], '--print-endpoints must be json'],
    [['--busy-percent', '0'], '--busy-percent must be a number from 1 to 100'],
    [['--publisher-percent', 'much'], '--publisher-percent must be a number from 1 to 100'],
    [['--log-level', 'loud'], 'error, warn, info or debug'],
    [['--allowed-origins', 'example.org'], 'such as https://example.org'],
    // [AC-46]
    [['--allowed-origins', 'null'], 'pages opened from files send it, and any website can'],
    [['--allowed-origins', 'https://a.b,NULL'], 'uses a token of its own'],
    [['--trust-loopback', '--loopback', 'none'], 'Remove one of them'],
    [['--loopback', 'admin'], '--loopback must be participant or none'],
    [['--trusted-proxy', 'lab.local'], 'networks separated by commas'],
    // [CU-62]
    [['--cluster', 'nats://ann:secret@a/x'], '--cluster must be addresses of NATS servers'],
    [['--cluster', 'nats://a', '--cluster-name', 'a.b'], '1 to 32 lower-case letters'],
    [['--cluster-name', 'lab'], '--cluster-name is of use with --cluster only'],
    [['--cluster-ca', 'ca.pem'], '--cluster-ca is of use with --cluster only'],
    [['--cluster-insecure'], '--cluster-insecure is of use with --cluster only'],
    [['--cluster', 'nats://a:b@c', '--cluster-credentials', 'f'], 'have a login for NATS'],
    [['--name', ' '], '1 to 100 characters'],
    [['--port'], 'needs a value: --port <number>'],
    [['--port', '--lan'], 'needs a value'],
    [['--prot', '1'], 'Unknown flag --prot. Use --help to list all flags.'],
    [['-p', '1'], 'Unknown flag -p'],
    [['8080'], 'Unexpected argument "8080"'],
    [['--lan', '--host', '0.0.0.0'], 'Remove one of them'],
    [['--allow-legacy', '10.0.0.0/33'], 'networks separated by commas'],
    [['--allow-legacy', 'lab.local'], 'networks separated by commas'],
    [['--allow-legacy', '10.0.0.0/'], 'networks separated by commas'],
    [
      ['--config', '/nowhere/at-all.json'],
      '/nowhere/at-all.json, must be readable and contain JSON',
    ],
  ])('%j', (args, expected) => {
    const message = messageOf(args);
    expect(message).toContain(expected);
    expect(message).toMatch(/\.$/);
    expect(message).not.toContain('\n');
    expect(message).not.toContain('secret');
  });

  it('names the environment variable', () => {
    expect(messageOf([], { UBII_PORT: 'x' })).toContain(
      'but is "x" in the environment variable UBII_PORT',
    );
  });

  it('names the file and the key', () => {
    const wrongValue = configFile({ port: true });
    expect(messageOf(['--config', wrongValue])).toContain(`in the config file ${wrongValue}`);
    expect(messageOf(['--config', configFile({ prot: 1 })])).toContain('the key "prot"');
    expect(messageOf(['--config', configFile({ port: {} })])).toContain('but is an object');
    expect(messageOf(['--config', configFile('{')])).toContain('contain JSON');
    expect(messageOf(['--config', configFile('[]')])).toContain('one JSON object');
    expect(messageOf(['--config', configFile({ config: 'x' })])).toContain('is not an option');
  });
});

describe('hosts', () => {
  it.each([
    ['127.0.0.1', '127.0.0.1'],
    ['[::1]', '::1'],
    ['fe80::1', 'fe80::1'],
    ['My-PC.local', 'my-pc.local'],
  ])('%s', (text, expected) => expect(resolve(['--host', text]).host).toBe(expected));
});
