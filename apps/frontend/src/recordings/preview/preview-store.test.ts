import { describe, expect, it } from 'vitest';
import type { PreviewReport, RecordingPreview } from './preview-messages.ts';
import { PreviewStore } from './preview-store.ts';
import { previewText } from './preview-words.ts';

const aPreview = (changes: Partial<RecordingPreview> = {}): RecordingPreview => ({
  ...{ durationMs: 1000, records: 2, topics: 1, hasPicture: false },
  ...{ activity: Float32Array.of(1), tracks: [], markers: [] },
  ...changes,
});

function setUp() {
  const asked: string[] = [];
  let handle: (report: PreviewReport) => void = () => undefined;
  let opened = 0;
  const store = new PreviewStore(() => {
    opened += 1;
    return {
      send: ({ key }) => void asked.push(key),
      onReport: (take) => void (handle = take),
      close: () => undefined,
    };
  });
  const show = (key: string): void => store.show({ key, source: new Blob() });
  return {
    asked,
    store,
    show,
    tell: (report: PreviewReport) => handle(report),
    opened: () => opened,
  };
}

describe('previews', () => {
  it('are read two at a time, the last one shown first, and not after leaving the screen', () => {
    const { asked, store, show, tell, opened } = setUp();
    expect(opened()).toBe(0);
    for (const key of ['a', 'b', 'c', 'd', 'e']) show(key);
    expect(asked).toEqual(['a', 'b']);
    store.hide('d');
    tell({ kind: 'preview', key: 'a', preview: aPreview() });
    tell({ kind: 'failed', key: 'b', message: 'Gone.' });
    expect(asked).toEqual(['a', 'b', 'e', 'c']);
    expect(opened()).toBe(1);
  });

  it('are read once, and again after a failure', () => {
    const { asked, show, store, tell } = setUp();
    show('a');
    show('b');
    tell({ kind: 'preview', key: 'a', preview: aPreview() });
    tell({ kind: 'failed', key: 'b', message: 'Gone.' });
    show('a');
    show('b');
    expect(asked).toEqual(['a', 'b', 'b']);
    expect(store.get('b')?.problem).toBe('Gone.');
  });

  it('keep their place until the picture came', () => {
    const { asked, show, store, tell } = setUp();
    for (const key of ['a', 'b', 'c']) show(key);
    tell({ kind: 'preview', key: 'a', preview: aPreview({ hasPicture: true }) });
    expect(asked).toEqual(['a', 'b']);
    tell({ kind: 'picture', key: 'a', picture: undefined });
    expect(asked).toEqual(['a', 'b', 'c']);
    expect(store.get('a')?.preview?.hasPicture).toBe(true);
  });

  it('close the pictures of those that were shown longest ago', () => {
    const { show, store, tell } = setUp();
    const closed: string[] = [];
    for (let i = 0; i <= 200; i++) {
      const key = String(i);
      show(key);
      tell({ kind: 'preview', key, preview: aPreview({ hasPicture: true }) });
      const picture = { close: () => closed.push(key) } as unknown as ImageBitmap;
      tell({ kind: 'picture', key, picture });
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
