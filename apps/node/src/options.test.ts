import { ConfigError, flagName, formatHelp, readOptions } from '@ubii/program';
import { describe, expect, it } from 'vitest';
import { NODE_PROGRAM, OPTIONS } from './options.ts';

const read = (args: string[], env = {}) => readOptions(NODE_PROGRAM, args, env, '/home/ada').values;

describe('the configuration', () => {
  it('prefers a flag to the environment, and the environment to the default', () => {
    const env = { UBII_NODE_NAME: 'hall', UBII_NODE_CAPACITY: '4', UBII_NODE_MODULES: '' };
    expect(read(['--name', 'kitchen', '--no-accept-work'], env)).toMatchObject({
      name: 'kitchen',
      capacity: 4,
      modules: undefined,
      noAcceptWork: true,
      master: 'http://localhost:8080',
      allowFetch: [],
    });
  });

  it('parses the values', () => {
    expect(
      read([
        '--master=http://192.168.1.20:8080/',
        ...['--modules', 'my modules', '--identity', 'off'],
        ...['--allow-fetch', 'https://example.org, http://sensor.local:8000/'],
      ]),
    ).toMatchObject({
      master: 'http://192.168.1.20:8080',
      modules: '/home/ada/my modules',
      identity: 'off',
      allowFetch: ['https://example.org', 'http://sensor.local:8000'],
    });
  });

  it.each([
    [['--master', 'localhost:8080'], '--master must be an http or https URL'],
    [['--master', 'http://x/services'], 'without a path'],
    [['--master', 'http://x', '--discover'], 'Remove one of them'],
    [['--capacity', '-1'], '--capacity must be a whole number'],
    [['--log-level', 'loud'], 'error, warn, info or debug'],
    [['--name', ''], '1 to 100 characters'],
    [['--print-endpoints', 'xml'], '--print-endpoints must be json'],
    [['--name', '--capacity'], '--name needs a value'],
  ])('refuses %j with the expected value', (args, reason) => {
    expect(() => read(args)).toThrow(ConfigError);
    expect(() => read(args)).toThrow(reason);
  });

  it('lists every option in the help', () => {
    const help = formatHelp(NODE_PROGRAM);
    for (const name of Object.keys(OPTIONS)) {
      expect(help).toContain(`  ${flagName(name)}`);
    }
    for (const line of help.split('\n')) expect(line.length).toBeLessThanOrEqual(96);
  });
});
