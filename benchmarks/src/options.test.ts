import { ConfigError, readOptions } from '@ubii/program';
import { describe, expect, it } from 'vitest';
import { benchmarkProgram, createOptions } from './options.ts';

const GROUPS = ['round-trip', 'fan-out'];

function parseOptions(args: readonly string[]) {
  return createOptions(readOptions(benchmarkProgram(GROUPS), args, {}, '/folder'), GROUPS);
}

describe('the options of the benchmarks', () => {
  it('runs everything unless told what', () => {
    expect(parseOptions([])).toMatchObject({ command: 'run', groups: GROUPS });
    expect(parseOptions(['fan-out', '--rounds', '7'])).toMatchObject({
      groups: ['fan-out'],
      rounds: 7,
    });
  });

  it('compares two files', () => {
    expect(parseOptions(['compare', 'a.json', 'b.json'])).toEqual({
      command: 'compare',
      before: 'a.json',
      after: 'b.json',
    });
    expect(() => parseOptions(['compare', 'a.json'])).toThrow(ConfigError);
  });

  it('says what there is when it does not know a workload', () => {
    expect(() => parseOptions(['fan-in'])).toThrow(
      'There is no workload "fan-in"; there are round-trip and fan-out.',
    );
  });

  it.each([
    ['--rounds', '2'],
    ['--rounds', '3.5'],
    ['--seconds', 'x'],
    ['--seconds', ''],
    ['--fast'],
  ])('refuses %s %s', (...args) => {
    expect(() => parseOptions(args.filter(Boolean))).toThrow(ConfigError);
  });
});
