import { describe, expect, it } from 'vitest';
import { parseOptions, UsageError } from './options.ts';

const GROUPS = ['round-trip', 'fan-out'];

describe('parseOptions', () => {
  it('runs everything unless told what', () => {
    expect(parseOptions([], GROUPS)).toMatchObject({ command: 'run', groups: GROUPS });
    expect(parseOptions(['fan-out', '--rounds', '7'], GROUPS)).toMatchObject({
      groups: ['fan-out'],
      rounds: 7,
    });
  });

  it('compares two files', () => {
    expect(parseOptions(['compare', 'a.json', 'b.json'], GROUPS)).toEqual({
      command: 'compare',
      before: 'a.json',
      after: 'b.json',
    });
    expect(() => parseOptions(['compare', 'a.json'], GROUPS)).toThrow(UsageError);
  });

  it('says what there is when it does not know a workload', () => {
    expect(() => parseOptions(['fan-in'], GROUPS)).toThrow(
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
    expect(() => parseOptions(args.filter(Boolean), GROUPS)).toThrow(UsageError);
  });
});
