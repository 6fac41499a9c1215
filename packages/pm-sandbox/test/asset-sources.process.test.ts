import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { readFile } from 'node:fs/promises';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { AssetError, ASSETS_PATH, createAssetStore, createHttpAssets } from '../src/index.ts';
import type { AssetSource } from '../src/index.ts';
import { AssetFolders } from '../src/node/index.ts';
import { manifestOf } from '../src/testing/index.ts';

const never = new AbortController().signal;
const TEXTS = { 'model.json': '{"a":1}', 'parts/one.bin': 'one' };
let folder: string;
let server: Server | undefined;

beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'ubii-assets-'));
  for (const [path, text] of Object.entries(TEXTS)) write(`written/${path}`, text);
  write('written/manifest.json', JSON.stringify(manifestOf('written', TEXTS)));
  for (const [path, text] of Object.entries(TEXTS)) write(`placed/${path}`, text);
});
afterEach(() => {
  rmSync(folder, { recursive: true });
  server?.close();
  server = undefined;
});

function write(path: string, text: string): void {
  mkdirSync(dirname(join(folder, path)), { recursive: true });
  writeFileSync(join(folder, path), text);
}

/** Serves the folder as a master does. */
async function overHttp(): Promise<AssetSource> {
  const folders = new AssetFolders([folder]);
  server = createServer((request, response) => {
    const [name = '', ...rest] = request.url!.slice(ASSETS_PATH.length + 1).split('/');
    const send = async (): Promise<string | Buffer> =>
      rest[0] === 'manifest.json'
        ? JSON.stringify(await folders.manifest(name))
        : readFile(await folders.pathOf(name, rest.slice(1).join('/')));
    send().then(
      (body) => response.end(body),
      () => response.writeHead(404).end(),
    );
  });
  await new Promise<void>((resolve) => server!.listen(0, '127.0.0.1', resolve));
  return createHttpAssets(`http://127.0.0.1:${(server.address() as AddressInfo).port}`);
}

describe.each([
  ['folders', async () => new AssetFolders([folder])],
  ['HTTP', overHttp],
] as const)('asset sets from %s', (_name, open) => {
  it.each(['written', 'placed'])('are read and verified: %s [PM-93]', async (name) => {
    const store = createAssetStore(await open());
    const [set] = await store.load([name], never, () => undefined);
    const texts = Object.entries(set!.files).map(([path, bytes]) => [
      path,
      new TextDecoder().decode(bytes),
    ]);
    expect(Object.fromEntries(texts)).toEqual(TEXTS);
  });

  it('say that a set is missing, and what to do [PM-95]', async () => {
    const source = await open();
    const asked = source.manifest('none', never);
    await expect(asked).rejects.toBeInstanceOf(AssetError);
    await expect(asked).rejects.toThrow('models/none');
  });

  it('say that a file was changed [PM-95]', async () => {
    const store = createAssetStore(await open());
    write('written/model.json', '{"a":2}');
    await expect(store.load(['written'], never, () => undefined)).rejects.toThrow(
      'The file model.json of the asset set written is damaged',
    );
  });

  it('end with their signal', async () => {
    const source = await open();
    const { files } = await source.manifest('written', never);
    const abort = new AbortController();
    const read = source.read('written', files[0]!, abort.signal, () => undefined);
    abort.abort(new Error('stopped'));
    await expect(read).rejects.toThrow('stopped');
  });
});

it('a master that is away is told from a set that is missing', async () => {
  const source = createHttpAssets('http://127.0.0.1:9');
  await expect(source.manifest('written', never)).rejects.toThrow(
    'The asset set written could not be loaded',
  );
});

describe('folders of asset sets [PM-93]', () => {
  it('make a manifest again after a file was replaced', async () => {
    const folders = new AssetFolders([folder]);
    const before = await folders.manifest('placed');
    expect(await folders.manifest('placed')).toBe(before);
    write('placed/parts/one.bin', 'two!');
    expect((await folders.manifest('placed')).files[1]?.bytes).toBe(4);
  });

  it('give the set of the later folder', async () => {
    write('later/placed/x.bin', 'x');
    const folders = new AssetFolders([folder, join(folder, 'later')]);
    expect((await folders.manifest('placed')).files.map(({ path }) => path)).toEqual(['x.bin']);
  });

  it('give no file outside of a set', async () => {
    const folders = new AssetFolders([folder]);
    for (const path of ['../written/model.json', '/etc/passwd', 'manifest.json', '']) {
      await expect(folders.pathOf('placed', path)).rejects.toThrow('has no file');
    }
    await expect(folders.manifest('..')).rejects.toThrow('no asset set');
  });
});
