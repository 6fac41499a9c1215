import { readFileSync, readdirSync } from 'node:fs';
import { DEFAULT_RUNTIME_LIMITS } from '@ubii/pm-sandbox';
import { describe, expect, it } from 'vitest';
import { DEFAULT_LIMITS } from '../src/core/limits/index.ts';

const REPOSITORY = new URL('../../../', import.meta.url);
const SPEC = new URL('docs/spec/', REPOSITORY);
/** Source files of documented constants that are in no table of limits. */
const CONSTANT_FILES = [
  'packages/pm-sandbox/src/sandbox-limits.ts',
  'packages/proto/src/binary/max-nested-messages.ts',
  'apps/master/src/core/sessions/supervision.ts',
];
const UNITS: Readonly<Record<string, number>> = {
  KiB: 1024,
  MiB: 1024 ** 2,
  GiB: 1024 ** 3,
  ms: 1,
  s: 1_000,
  min: 60_000,
  h: 3_600_000,
};
/** `name` (number unit): a limit and its value, as rules write it. */
const VALUE = /`(\w+)` \((\d[\d ]*)(?: (KiB|MiB|GiB|ms|s|min|h))?\)/g;
/** Names that only limits have. */
const NAME = /`([a-z]\w*(?:Bytes|PerSecond|Per[A-Z][a-z]+|Characters|TimeoutMs|RetentionMs))`/g;
const CONSTANT_NAME = /`((?:MAX|MIN)_\w+|\w+_(?:MS|BYTES|HZ|PER_SECOND))`/g;

const pages = readdirSync(SPEC).map(
  (name) => [name, readFileSync(new URL(name, SPEC), 'utf8')] as const,
);
const constants = new Map(
  CONSTANT_FILES.flatMap((path) =>
    [...readFileSync(new URL(path, REPOSITORY), 'utf8').matchAll(/const (\w+) = ([\d_ *]+);/g)].map(
      ([, name = '', product = '']) => [name, multiply(product)] as const,
    ),
  ),
);

function multiply(product: string): number {
  return product
    .split('*')
    .map((factor) => Number(factor.replaceAll('_', '')))
    .reduce((all, factor) => all * factor, 1);
}

/** The values of a limit; nodes have limits with the names of the master's. */
function valuesOf(name: string): readonly number[] {
  const tables: readonly Readonly<Record<string, number>>[] = [
    DEFAULT_LIMITS,
    { ...DEFAULT_RUNTIME_LIMITS },
    Object.fromEntries(constants),
  ];
  return tables.flatMap((table) => table[name] ?? []);
}

const named = (text: string, pattern: RegExp): string[] =>
  [...text.matchAll(pattern)].map(([, name = '']) => name);

describe.each(pages)('docs/spec/%s', (_page, text) => {
  it('has the values of the limits in the code', () => {
    for (const [, name = '', digits = '', unit = ''] of text.matchAll(VALUE)) {
      const value = Number(digits.replaceAll(' ', '')) * (UNITS[unit] ?? 1);
      expect(valuesOf(name), name).toContain(value);
    }
  });

  it('names limits as the code does', () => {
    const names = [...named(text, NAME), ...named(text, CONSTANT_NAME)];
    expect(names.filter((name) => valuesOf(name).length === 0)).toEqual([]);
  });
});

it('finds limits with and without values', () => {
  expect(pages.flatMap(([, text]) => named(text, VALUE)).length).toBeGreaterThan(40);
  expect(pages.flatMap(([, text]) => named(text, NAME)).length).toBeGreaterThan(20);
  expect(valuesOf('topicBytes')).toEqual([1024]);
  expect(valuesOf('MAX_SOURCE_BYTES')).toEqual([1024 * 1024]);
  expect(valuesOf('MAX_TOPIC_BYTES')).toEqual([]);
});
