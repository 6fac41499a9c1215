import type { Mark } from '@ubii/proto';
import { expect, it } from 'vitest';
import { createOwnMark, keptMark } from './own-mark.ts';

const BLUE: Mark = { shape: 2, colour: 2, chosen: true };

/** Storage and client in memory. */
function createWorld() {
  const items = new Map<string, string>();
  const storage = {
    getItem: (key: string) => items.get(key) ?? null,
    setItem: (key: string, text: string) => void items.set(key, text),
  };
  const listeners: (() => void)[] = [];
  const client = {
    mark: undefined as Mark | undefined,
    onState: (fn: () => void) => {
      listeners.push(fn);
      return () => undefined;
    },
    updateProfile: ({ mark }: { mark?: unknown }) => {
      client.mark = mark as Mark;
      return Promise.resolve();
    },
  };
  const connect = (given: Mark) => {
    client.mark = given;
    for (const listener of listeners) listener();
  };
  return { storage, client, connect };
}

it('a mark is kept for the next time', () => {
  const { storage, client } = createWorld();
  createOwnMark(client as never, storage).set(BLUE);
  expect(keptMark(storage)).toEqual(BLUE);
});

it('a page has the mark that the master gave it', () => {
  const { storage, client, connect } = createWorld();
  const own = createOwnMark(client as never, storage);
  connect(BLUE);
  expect(own.current.value).toEqual(BLUE);
  expect(own.kept.value).toBeUndefined();
});

it('text that is no mark is none', () => {
  const { storage } = createWorld();
  for (const text of ['', 'x', 'null', '{"shape":"circle","colour":1}']) {
    storage.setItem('ubii.mark', text);
    expect(keptMark(storage)).toBeUndefined();
  }
});
