import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { DocumentStore } from '../../core/ports/document-store.ts';

/** A store, with hands that change its documents from outside. */
export interface StoreParts {
  readonly store: DocumentStore;
  /** Another program writes this text, or removes the document. Resolves when the store has noticed. */
  readonly edit: (key: string, text: string | undefined) => Promise<void>;
  /** Another store over the same documents, as the next run of the master has. */
  readonly reopen: () => DocumentStore | Promise<DocumentStore>;
  /** Ends what the store needs. Default: nothing */
  readonly end?: () => Promise<void>;
}

/** Acceptance tests of document stores. [SE-20] [SE-23] */
export function documentStoreSuite(
  name: string,
  open: () => StoreParts | Promise<StoreParts>,
): void {
  describe(`${name}, a DocumentStore`, () => {
    let parts: StoreParts;
    beforeEach(async () => {
      parts = await open();
    });
    afterEach(async () => {
      parts.store.close();
      await parts.end?.();
    });

    it('begins empty', () => {
      expect(parts.store.documents().size).toBe(0);
    });

    it('keeps what is written, and gives it to the next run', async () => {
      await parts.store.write('a', { name: 'a', list: [1, 'two', null, { deep: true }] });
      const expected = { json: { name: 'a', list: [1, 'two', null, { deep: true }] } };
      expect(parts.store.documents().get('a')).toEqual(expected);
      const next = await parts.reopen();
      expect(next.documents().get('a')).toEqual(expected);
      next.close();
    });

    it('replaces, and deletes', async () => {
      await parts.store.write('a', { n: 1 });
      await parts.store.write('a', { n: 2 });
      await parts.store.write('b', { n: 3 });
      expect([...parts.store.documents()]).toEqual([
        ['a', { json: { n: 2 } }],
        ['b', { json: { n: 3 } }],
      ]);
      await parts.store.delete('a');
      await parts.store.delete('a');
      expect([...parts.store.documents().keys()]).toEqual(['b']);
    });

    it('lets the last of many writes win', async () => {
      await Promise.all(Array.from({ length: 20 }, (_, n) => parts.store.write('a', { n })));
      expect(parts.store.documents().get('a')).toEqual({ json: { n: 19 } });
    });

    it.each([
      'with space',
      'a/b\\c',
      '../../escape',
      '.hidden',
      'C:con?*|"<>',
      'con',
      'ends.',
      '100%',
      'Füße 日本 🙂',
      'x'.repeat(300),
      `${'x'.repeat(300)}y`,
      '\u0000\n',
    ])('takes the name %.20j', async (key) => {
      await parts.store.write(key, { name: key });
      await parts.store.write('another', { name: 'another' });
      const found = [...parts.store.documents().values()].map(({ json }) => json);
      expect(found).toContainEqual({ name: key });
      expect(found).toHaveLength(2);
      const next = await parts.reopen();
      expect(next.documents().size).toBe(2);
      next.close();
    });

    it('takes what is changed by hand at once, and tells', async () => {
      const told: string[] = [];
      parts.store.onChange((keys) => told.push(...keys));
      await parts.edit('hand', '{"n":1}');
      expect(parts.store.documents().get('hand')).toEqual({ json: { n: 1 } });
      await parts.edit('hand', '{"n":22}');
      expect(parts.store.documents().get('hand')).toEqual({ json: { n: 22 } });
      await parts.edit('hand', undefined);
      expect(parts.store.documents().has('hand')).toBe(false);
      expect(new Set(told)).toEqual(new Set(['hand']));
    });

    it('leaves alone what is broken, and says why', async () => {
      await parts.store.write('good', { n: 1 });
      await parts.edit('broken', '{"n":');
      expect(parts.store.documents().get('broken')).toEqual({ fault: expect.any(String) });
      expect(parts.store.documents().get('good')).toEqual({ json: { n: 1 } });
      expect(parts.store.describe('broken')).toContain('broken');
      await parts.store.write('broken', { n: 2 });
      expect(parts.store.documents().get('broken')).toEqual({ json: { n: 2 } });
    });

    it('does not report its own writes, or any change after it is closed', async () => {
      const told: string[] = [];
      const cancel = parts.store.onChange((keys) => told.push(...keys));
      await parts.store.write('own', { n: 1 });
      await parts.edit('other', '{}');
      cancel();
      expect(told).toEqual(['other']);
    });
  });
}
