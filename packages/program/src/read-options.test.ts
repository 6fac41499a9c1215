import { describe, expect, it } from 'vitest';
import { ConfigError, option, type ProgramOptions } from './option.ts';
import { formatHelp } from './run-program.ts';
import { parseSwitch, parseWholeNumber } from './kinds-of-options.ts';
import { readOptions } from './read-options.ts';

const options = {
  count: option({
    placeholder: '<number>',
    fallback: 1,
    description: 'Number of things.',
    hint: 'Use --count 3 for a few things',
    parse: parseWholeNumber(0, 9),
  }),
  lights: option({
    placeholder: '[on|off]',
    fallback: false,
    description: 'Lights.',
    parse: parseSwitch,
  }),
  key: option<string | undefined>({
    placeholder: '<key>',
    fallback: undefined,
    description: 'A secret.',
    isSecret: true,
    parse() {
      throw new Error('a key');
    },
  }),
};
const program: ProgramOptions<typeof options> = {
  options,
  about: 'A program.\n',
  notes: 'Ends with 1.',
  takesWords: true,
};

function read(...args: string[]) {
  const { values, words } = readOptions(program, args, { COUNT: '7', UBII_COUNT: '8' }, '/');
  return { ...values, words };
}

describe('options of a program', () => {
  it('may stand between words', () => {
    expect(read('compare', '--count', '2', 'a', '--lights', 'b')).toEqual({
      count: 2,
      lights: true,
      key: undefined,
      words: ['compare', 'a', 'b'],
    });
  });

  it('take no word that is no value of a switch, and none after --', () => {
    expect(read('--lights', 'off')).toMatchObject({ lights: false, words: [] });
    expect(read('--lights', '--', 'off')).toMatchObject({ lights: true, words: ['off'] });
    expect(read('--', '--count')).toMatchObject({ count: 1, words: ['--count'] });
  });

  it('are checked together, with what is set', () => {
    const checked: ProgramOptions<typeof options> = {
      ...program,
      check({ lights }, given) {
        if (lights && given.has('count')) throw new ConfigError('Remove one of them.');
      },
    };
    expect(() => readOptions(checked, ['--lights', '--count=2'], {}, '/')).toThrow('Remove one');
    expect(readOptions(checked, ['--lights'], {}, '/').given).toEqual(new Set(['lights']));
  });

  it('are not read from the environment of a program without a prefix', () => {
    expect(read()).toMatchObject({ count: 1 });
    expect(
      readOptions({ ...program, environmentPrefix: 'UBII_' }, [], { UBII_COUNT: '8' }, '/'),
    ).toMatchObject({ values: { count: 8 }, given: new Set(['count']) });
  });

  it.each([
    [['--count', '10'], 'The option --count must be a whole number from 0 to 9, but is "10"'],
    [['--count', '10'], 'on the command line. Use --count 3 for a few things.'],
    [
      ['--count', '--lights'],
      'The flag --count needs a value: --count <number>. Number of things.',
    ],
    [['--count'], 'needs a value'],
    [['-xyz=1'], 'Unknown flag -xyz. Use --help'],
    [['--toString'], 'Unknown flag --toString.'],
    [['--key', 'hunter2'], 'must be a key, but is something else on the command line'],
  ])('refuse %j', (args, message) => {
    expect(() => read(...args)).toThrow(ConfigError);
    expect(() => read(...args)).toThrow(message);
  });

  it('are listed in the help, from where they can come', () => {
    const { count } = options;
    expect(formatHelp({ options: { count }, about: 'A program.\n', notes: 'Ends with 1.' })).toBe(
      'A program.\n\n  --count <number>\n      Number of things.\n      default: 1\n\nEnds with 1.\n',
    );
    expect(formatHelp({ ...program, environmentPrefix: 'X_', fileOption: 'key' })).toContain(
      '      X_COUNT, "count"; default: 1\n',
    );
  });
});
