import { readdirSync } from 'node:fs';
import { moduleLibrary } from '@ubii/modules';
import { DATA_FORMATS, SERVICES } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { entryId, REFERENCE_PAGES } from './reference-pages.ts';
import { REFERENCE_TITLES } from './reference-titles.ts';

const entriesOf = (id: string) =>
  REFERENCE_PAGES.find((page) => page.id === id)?.sections.flatMap(({ entries }) => entries) ?? [];

describe('the reference', () => {
  it('has every data format with its comment in the schema', () => {
    const entries = entriesOf('data-formats');
    expect(entries.map(({ name }) => name).sort()).toEqual(Object.keys(DATA_FORMATS).sort());
    for (const { sentence } of entries) expect(sentence).not.toBe('');
    const vector = entries.find(({ name }) => name === 'vector2');
    expect(vector?.sentence).toBe('Two numbers.');
    expect(vector?.fields?.map(({ name, type }) => [name, type])).toEqual([
      ['x', 'double'],
      ['y', 'double'],
    ]);
  });

  it('has every service with the roles that may call it', () => {
    const entries = entriesOf('services');
    expect(entries).toHaveLength(Object.keys(SERVICES).length);
    const rights = (name: string) =>
      entries
        .find((entry) => entry.name === name)
        ?.facts.find(([label]) => label === 'Allowed for');
    expect(rights('server_configuration')).toEqual(['Allowed for', 'every caller']);
    for (const { name } of entries) expect(rights(name)?.[1]).not.toBe('no role');
  });

  it('has every module of the library', () => {
    const names = moduleLibrary().map(({ name }) => name);
    expect(entriesOf('modules').map(({ name }) => name)).toEqual(names);
  });

  it('has paths, messages and close codes of the protocol, and the words of the glossary', () => {
    const protocol = entriesOf('wire-protocol').map(({ name }) => name);
    expect(protocol).toContain('POST /services/json');
    expect(protocol).toContain('TopicDataRecord');
    expect(protocol.some((name) => name.startsWith('4001'))).toBe(true);
    expect(entriesOf('glossary').map(({ name }) => name)).toContain('master');
  });

  it('has every guide of the repository, with its file', () => {
    const files = readdirSync(new URL('../../../../../docs/guides', import.meta.url))
      .filter((name) => name !== 'README.md')
      .map((name) => `\`docs/guides/${name}\``);
    const shown = entriesOf('guides').map(({ facts }) => facts[0]?.[1]);
    expect(shown.sort()).toEqual(files.sort());
  });

  it('names no rules, and gives each entry of a page an address of its own', () => {
    for (const { id } of REFERENCE_PAGES) {
      const entries = entriesOf(id);
      for (const { sentence } of entries) expect(sentence).not.toMatch(/\b[A-Z]{2}-\d/);
      expect(new Set(entries.map(({ name }) => entryId(name))).size).toBe(entries.length);
    }
  });

  it('is listed in the contents', () => {
    expect(REFERENCE_TITLES).toEqual(REFERENCE_PAGES.map(({ id, title }) => ({ id, title })));
  });
});
