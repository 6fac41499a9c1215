import { ModuleOrigin } from '@ubii/proto';
import { expect, it } from 'vitest';
import { aSession } from '../../sessions/testing/a-session.ts';
import { moduleEntries } from '../library/module-entry.ts';
import { importedWords, withoutFixed } from './import-words.ts';

const [mirror] = aSession().processingModules;
const named = (name: string, origin?: ModuleOrigin) => ({
  ...mirror!,
  name,
  ...(origin === undefined ? {} : { extension: { origin } as never }),
});
const entries = moduleEntries(
  [
    named('clock', ModuleOrigin.MODULE_ORIGIN_BUILT_IN),
    named('mine', ModuleOrigin.MODULE_ORIGIN_STORED),
  ],
  [],
  [],
);

it('leaves out of a whole library what came with the program', () => {
  const names = withoutFixed([named('clock'), named('mine')], entries).map(({ name }) => name);
  expect(names).toEqual(['mine']);
});

it('lets the master refuse what was imported alone', () => {
  expect(withoutFixed([named('clock')], entries)).toHaveLength(1);
});

it('says what came of it', () => {
  expect(importedWords(1, 1)).toBeUndefined();
  expect(importedWords(3, 3)).toBe('Imported 3 modules');
  expect(importedWords(1, 23)).toBe('Imported 1 of 23 modules: 22 are built-in modules.');
  expect(importedWords(0, 22)).toMatch(/^Nothing to import: 22/);
});
