import { describe, expect, it } from 'vitest';
import { FakeAssets, manifestOf } from '../testing/fake-assets.ts';
import { readManifest } from './asset-manifest.ts';
import { createAssetStore, type AssetProgress } from './asset-store.ts';

const never = new AbortController().signal;
const quiet = (): void => undefined;
const textOf = (bytes: Uint8Array | undefined): string => new TextDecoder().decode(bytes);

function setUp(keptBytes?: number) {
  const source = new FakeAssets();
  source.add('small', { 'a.json': '{}', 'parts/b.bin': 'bytes' });
  return { source, store: createAssetStore(source, keptBytes) };
}

describe('a store of asset sets [PM-90]', () => {
  it('gives verified files, and tells how far it is', async () => {
    const { store } = setUp();
    const told: AssetProgress[] = [];
    const [set] = await store.load(['small'], never, (progress) => told.push(progress));
    expect(Object.keys(set!.files)).toEqual(['a.json', 'parts/b.bin']);
    expect(textOf(set!.files['parts/b.bin'])).toBe('bytes');
    expect(told.map(({ loadedBytes, totalBytes }) => [loadedBytes, totalBytes])).toEqual([
      [2, 7],
      [7, 7],
    ]);
  });

  it('loads once for all that wait, and keeps what was used last', async () => {
    const { source, store } = setUp();
    await Promise.all([store.load(['small'], never, quiet), store.load(['small'], never, quiet)]);
    await store.load(['small'], never, quiet);
    expect(source.reads).toEqual(['small/a.json', 'small/parts/b.bin']);
  });

  it('keeps no more than its bytes', async () => {
    const { source, store } = setUp(10);
    source.add('other', { c: '12345' });
    await store.load(['small', 'other'], never, quiet);
    await store.load(['other'], never, quiet);
    expect(source.reads).toHaveLength(3);
    await store.load(['small'], never, quiet);
    expect(source.reads).toHaveLength(5);
  });

  it('loads a set again that has changed', async () => {
    const { source, store } = setUp();
    await store.load(['small'], never, quiet);
    source.add('small', { 'a.json': '[]' });
    const [set] = await store.load(['small'], never, quiet);
    expect(textOf(set!.files['a.json'])).toBe('[]');
  });

  it('goes on while somebody waits, and ends with the last', async () => {
    const { source, store } = setUp();
    let go!: () => void;
    source.pause = new Promise((resolve) => (go = resolve));
    const [first, second] = [new AbortController(), new AbortController()];
    const one = store.load(['small'], first.signal, quiet);
    const two = store.load(['small'], second.signal, quiet);
    first.abort(new Error('stopped'));
    await expect(one).rejects.toThrow('stopped');
    go();
    await expect(two).resolves.toHaveLength(1);

    source.add('small', { 'a.json': 'new' });
    source.pause = new Promise((resolve) => (go = resolve));
    const three = store.load(['small'], second.signal, quiet);
    second.abort(new Error('stopped'));
    await expect(three).rejects.toThrow('stopped');
    go();
    await expect(store.load(['small'], never, quiet)).resolves.toHaveLength(1);
  });

  it('refuses what differs from the manifest, and says what is wrong [PM-95]', async () => {
    const { source, store } = setUp();
    const { manifest } = source.sets.get('small')!;
    source.sets.set('small', { manifest, texts: { 'a.json': '[]', 'parts/b.bin': 'bytes' } });
    await expect(store.load(['small'], never, quiet)).rejects.toThrow(
      'The file a.json of the asset set small is damaged: its SHA-256 differs from the manifest.',
    );
    source.sets.set('small', { manifest, texts: { 'a.json': '{} ', 'parts/b.bin': 'bytes' } });
    await expect(store.load(['small'], never, quiet)).rejects.toThrow('3 bytes instead of 2');
  });

  it('reads a damaged file once more, past the caches on the way', async () => {
    const { source, store } = setUp();
    const fresh: boolean[] = [];
    const { read } = source;
    source.read = (name, file, signal, onBytes, isFresh = false) => {
      fresh.push(isFresh);
      return file.path === 'a.json' && !isFresh
        ? Promise.resolve(new Uint8Array([1, 2]))
        : read.call(source, name, file, signal, onBytes);
    };
    const told: number[] = [];
    const [set] = await store.load(['small'], never, ({ loadedBytes }) => told.push(loadedBytes));
    expect(textOf(set!.files['a.json'])).toBe('{}');
    expect(fresh).toEqual([false, true, false]);
    expect(told).toEqual([2, 7]);
  });

  it.each(['none', '../etc', '', 'A', 'a/b'])('says that there is no set %j', async (name) => {
    const { store } = setUp();
    await expect(store.load([name], never, quiet)).rejects.toThrow(
      `The master has no asset set ${name}.`,
    );
  });
});

describe('a manifest [PM-90]', () => {
  const good = manifestOf('small', { a: 'b' });

  it('is read as it is written', () => {
    expect(readManifest(JSON.parse(JSON.stringify(good)), 'small')).toEqual(good);
  });

  it.each([
    ['names another set', { ...good, name: 'other' }],
    ['lists no files', { ...good, files: [] }],
    [
      'lists more than 64 files',
      { ...good, files: Array.from({ length: 65 }, () => good.files[0]) },
    ],
    ['valid path', { ...good, files: [{ ...good.files[0], path: '../a' }] }],
    ['valid path', { ...good, files: [{ ...good.files[0], path: '/etc/passwd' }] }],
    ['valid path', { ...good, files: [{ ...good.files[0], path: 'a/.hidden' }] }],
    ['valid path', { ...good, files: [{ ...good.files[0], path: '__proto__' }] }],
    ['no size', { ...good, files: [{ ...good.files[0], bytes: -1 }] }],
    ['SHA-256', { ...good, files: [{ ...good.files[0], sha256: 'x' }] }],
    ['twice', { ...good, files: [good.files[0], good.files[0]] }],
    ['bytes of files', { ...good, files: [{ ...good.files[0], bytes: 2 ** 40 }] }],
    ['library', { ...good, library: 'c' }],
    ['lists no files', 'text'],
  ])('that %s is refused', (why, value) => {
    const other = typeof value === 'string' ? { name: 'small' } : value;
    expect(() => readManifest(other, 'small')).toThrow(why);
  });
});
