import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, vi } from 'vitest';

import { documentStoreSuite } from '../../testing/acceptance/index.ts';
import { FileDocuments } from './file-documents.ts';
import { fileNameOf, keyOfFileName } from './file-documents.ts';

function newFolder(): string {
  return join(temporaryFolder(), 'sessions');
}

/** Resolves when the store has noticed the change. */
async function heard(isThere: () => boolean): Promise<void> {
  await vi.waitFor(() => {
    if (!isThere()) throw new Error('not yet');
  }, 10_000);
}

documentStoreSuite('a folder', () => {
  const folder = newFolder();
  const store = new FileDocuments(folder, '.session');
  return {
    store,
    async edit(key, text) {
      const file = join(folder, `${key}.session`);
      const before = store.documents().get(key);
      if (text === undefined) rmSync(file);
      else writeFileSync(file, text);
      await heard(() => store.documents().get(key) !== before);
    },
    reopen: () => new FileDocuments(folder, '.session'),
  };
});

describe('a folder of documents', () => {
  it('has pretty files with the name of the document, and nothing else [SE-20]', async () => {
    const folder = newFolder();
    const store = new FileDocuments(folder, '.session');
    await store.write('my session', { name: 'my session', n: 1 });
    expect(readdirSync(folder)).toEqual(['my session.session']);
    const text = readFileSync(join(folder, 'my session.session'), 'utf8');
    expect(text).toBe('{\n  "name": "my session",\n  "n": 1\n}\n');
    store.close();
  });

  it('writes to the file that has the document, whatever that is called', async () => {
    const folder = newFolder();
    mkdirSync(folder, { recursive: true });
    writeFileSync(join(folder, 'An Old Name.session'), '{}');
    const store = new FileDocuments(folder, '.session');
    await store.write('An Old Name', { n: 1 });
    expect(readdirSync(folder)).toEqual(['An Old Name.session']);
    store.close();
  });

  it('is created again after it was removed', async () => {
    const folder = newFolder();
    const store = new FileDocuments(folder, '.session');
    rmSync(folder, { recursive: true });
    await store.write('a', { n: 1 });
    expect(store.documents().get('a')).toEqual({ json: { n: 1 } });
    store.close();
  });

  it('takes no other files for documents', () => {
    const folder = newFolder();
    mkdirSync(folder, { recursive: true });
    for (const name of ['.a.session', 'a.session.tmp', 'a.json', 'a.session~']) {
      writeFileSync(join(folder, name), '{}');
    }
    const store = new FileDocuments(folder, '.session');
    expect(store.documents().size).toBe(0);
    store.close();
  });
});

describe('filenames', () => {
  it.each(['plain', 'a/b', 'CON', 'com1', '50%', 'x.', ' y ', '%41'])('%j comes back', (key) => {
    expect(keyOfFileName(fileNameOf(key))).toBe(key);
  });

  it.each(['a/b', '..', '.x', 'nul', 'x:y', 'x\\y', 'x. '])('%j is safe', (key) => {
    expect(fileNameOf(key)).not.toMatch(/[/\\:]|^\.|[. ]$|^nul$/);
  });
});
