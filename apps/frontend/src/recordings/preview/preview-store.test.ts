import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import type { RecordingPreview } from './preview-messages.ts';
import { PreviewStore } from './preview-store.ts';
import { previewText } from './preview-words.ts';

const aPreview = (changes: Partial<RecordingPreview> = {}): RecordingPreview => ({
  durationMs: 1000,
  records: 2,
  topics: 1,
  hasPicture: false,
  activity: Float32Array.of(1),
  tracks: [],
  markers: [],
  ...changes,
});

interface Reply {
  readonly resolve: (value: never) => void;
  readonly reject: (error: Error) => void;
}

function setUp() {
  const asked: string[] = [];
  const replies = new Map<string, Reply>();
  let opened = 0;
  const replyTo = <T>(key: string): Promise<T> =>
    new Promise<T>((resolve, reject) => void replies.set(key, { resolve, reject }));
  const store = new PreviewStore(() => {
    opened += 1;
    return {
      calls: {
        readPreview({ key }) {
          asked.push(key);
          return replyTo(key);
        },
        readPicture: (key) => replyTo(`picture of ${key}`),
      },
      close: () => undefined,
    };
  });
  return {
    asked,
    store,
    show: (key: string): void => store.show({ key, source: new Blob() }),
    opened: () => opened,
    async reply(key: string, value: RecordingPreview | ImageBitmap | undefined): Promise<void> {
      replies.get(key)!.resolve(value as never);
      await settle();
    },
    async fail(key: string): Promise<void> {
      replies.get(key)!.reject(new Error('Gone.'));
      await settle();
    },
  };
}

describe('previews', () => {
  it('are read two at a time, the last one shown first, and not after leaving the screen', async () => {
    const { asked, store, show, reply, fail, opened } = setUp();
    expect(opened()).toBe(0);
    for (const key of ['a', 'b', 'c', 'd', 'e']) show(key);
    expect(asked).toEqual(['a', 'b']);
    store.hide('d');
    await reply('a', aPreview());
    await fail('b');
    expect(asked).toEqual(['a', 'b', 'e', 'c']);
    expect(opened()).toBe(1);
  });

  it('are read once, and again after a failure', async () => {
    const { asked, show, store, reply, fail } = setUp();
    show('a');
    show('b');
    await reply('a', aPreview());
    await fail('b');
    show('a');
    show('b');
    expect(asked).toEqual(['a', 'b', 'b']);
    expect(store.get('b')?.problem).toBe('Gone.');
  });

  it('keep their place until the picture came', async () => {
    const { asked, show, store, reply } = setUp();
    for (const key of ['a', 'b', 'c']) show(key);
    await reply('a', aPreview({ hasPicture: true }));
    expect(asked).toEqual(['a', 'b']);
    await reply('picture of a', undefined);
    expect(asked).toEqual(['a', 'b', 'c']);
    expect(store.get('a')?.preview?.hasPicture).toBe(true);
  });

  it('close the pictures of those that were shown longest ago', async () => {
    const { show, store, reply } = setUp();
    const closed: string[] = [];
    for (let i = 0; i <= 200; i++) {
      const key = String(i);
      show(key);
      await reply(key, aPreview({ hasPicture: true }));
      const picture = { close: () => closed.push(key) } as unknown as ImageBitmap;
      await reply(`picture of ${key}`, picture);
    }
    expect(closed).toEqual(['0']);
    expect(store.get('0')).toBeUndefined();
    store.close();
    expect(closed).toHaveLength(201);
  });
});

it('a preview has a description in words', () => {
  const track = { topic: '/a', label: '/a', family: 'number', records: 2 } as const;
  const tracks = [{ ...track, activity: Float32Array.of(2) }];
  const markers = [{ timeMs: 1, text: 'here' }];
  expect(previewText({ preview: aPreview({ tracks, markers }) })).toBe(
    'Most records: /a. 1 marker.',
  );
  expect(previewText({ preview: aPreview({ records: 0 }) })).toBe('No records');
  expect(previewText({ problem: 'The end of the file is missing.' })).toBe(
    'No preview. The end of the file is missing.',
  );
  expect(previewText(undefined)).toBeUndefined();
});
