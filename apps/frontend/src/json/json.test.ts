import * as v from 'valibot';
import { describe, expect, it } from 'vitest';
import { readImported, type ImportKind } from './read-imported.ts';
import { readStored, storedAs } from './read-stored.ts';
import {
  finite,
  flag,
  maybe,
  textCutAt,
  textUpTo,
  validElements,
  validMembers,
} from './schemas.ts';

const KIND: ImportKind = {
  what: 'shelves',
  mark: ['format', 'shelf'],
  version: ['version', 1],
  maxChars: 1000,
};
const SHELF = v.object({
  books: v.array(
    v.object({
      title: textUpTo(5),
      pages: v.pipe(finite, v.integer(), v.minValue(1), v.maxValue(9)),
      cover: v.optional(v.picklist(['soft', 'hard'])),
      tags: v.optional(v.pipe(v.array(v.string()), v.minLength(1)), ['none']),
      lent: v.optional(v.boolean(), false),
      owner: v.optional(v.pipe(v.string(), v.regex(/^a/, 'should begin with a'))),
    }),
  ),
});
const message = (text: string): string => {
  const read = readImported(KIND, SHELF, text);
  return read.kind === 'broken' ? read.message : JSON.stringify(read.value);
};
const ofBook = (book: object | string): string =>
  message(JSON.stringify({ format: 'shelf', books: [{ title: 'a', pages: 1, ...Object(book) }] }));

describe('imported JSON', () => {
  it('is read with its defaults, and without unknown members', () => {
    expect(ofBook({ color: 'red' })).toBe(
      '{"books":[{"title":"a","pages":1,"tags":["none"],"lent":false}]}',
    );
  });

  it.each([
    ['x'.repeat(1001), 'The file is too large: it contains no shelves.'],
    ['{', 'The file is not JSON. It may be cut off or damaged. Export it again.'],
    ['null', 'The file contains no shelves. Choose a file that this page exported.'],
    ['{"format":"box"}', 'The file contains no shelves. Choose a file that this page exported.'],
    [
      '{"format":"shelf","version":"2"}',
      'The file has an unknown version; this page reads version 1. Create it with the same version of Ubi-Interact.',
    ],
    ['{"format":"shelf"}', 'The file cannot be read: books is missing.'],
    ['{"format":"shelf","books":{}}', 'The file cannot be read: books should be a list.'],
    ['{"format":"shelf","books":[1]}', 'The file cannot be read: books[0] should be an object.'],
    [
      `{"format":"shelf","books":${'['.repeat(150)}${']'.repeat(150)}}`,
      'The file is damaged: it is nested too deeply.',
    ],
  ])('names what is wrong with %.40s', (text, sentence) => {
    expect(message(text)).toBe(sentence);
  });

  it.each([
    [{ title: 'abcdef' }, 'title should be a text of up to 5 characters.'],
    [{ title: 3 }, 'title should be a text.'],
    [{ pages: '3' }, 'pages should be a number.'],
    [{ pages: 1.5 }, 'pages should be a whole number.'],
    [{ pages: 0 }, 'pages should be 1 or more.'],
    [{ pages: 10 }, 'pages should be 9 or less.'],
    [{ cover: 'none' }, 'cover should be "soft" or "hard".'],
    [{ tags: [] }, 'tags should be a list of 1 or more elements.'],
    [{ lent: 1 }, 'lent should be true or false.'],
    [{ owner: 'Ben' }, 'owner should begin with a.'],
  ])('names place and expectation: %j', (book, sentence) => {
    expect(ofBook(book)).toBe(`The file cannot be read: books[0].${sentence}`);
  });
});

describe('stored JSON', () => {
  const SCHEMA = v.object({
    name: textCutAt(3),
    isOn: flag,
    size: maybe(finite),
    list: v.fallback(validElements(v.number(), 2), []),
    byName: v.fallback(validMembers(v.string()), {}),
  });

  it('keeps the parts that fit', () => {
    const text =
      '{"name":"abcd","isOn":1,"size":1e999,"list":["a",1,2,3],"byName":{"a":"x","b":1},"other":1}';
    expect(readStored(SCHEMA, text)).toEqual({
      name: 'abc',
      isOn: false,
      size: undefined,
      list: [1, 2],
      byName: { a: 'x' },
    });
  });

  it('is undefined when nothing fits, or there is too much', () => {
    for (const text of [null, '', '{', '3', 'null']) {
      expect(readStored(SCHEMA, text), String(text)).toBeUndefined();
    }
    expect(readStored(SCHEMA, '{}', 1)).toBeUndefined();
  });

  it('starts with a new value each time for storage that holds something else', () => {
    const { read, write } = storedAs(SCHEMA, {});
    const [first, second] = [read('['), read('[')];
    expect(first).toEqual({ name: '', isOn: false, list: [], byName: {} });
    expect(first).not.toBe(second);
    expect(read(write({ ...first, name: 'b' })).name).toBe('b');
  });
});
