import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { AssetFolders } from '@ubii/pm-sandbox/node';
import { FakeBucket, type BucketAnswer } from '../../testing/fake-bucket.ts';
import type { KnownModel } from './catalogue.ts';
import { downloadModel } from './download-model.ts';

const FILES = {
  'model.json': Buffer.from('{"a":1}'),
  'weights/part1': Buffer.alloc(100_000, 7),
};
const fileOf = ([path, content]: [string, Buffer]) => ({
  path,
  bytes: content.length,
  sha256: createHash('sha256').update(content).digest('hex'),
});
const TOTAL_BYTES = 100_007;

let bucket: FakeBucket;
let folder: string;
beforeEach(async () => {
  folder = temporaryFolder();
  bucket = await FakeBucket.open(FILES);
});
afterEach(() => bucket.close());

const model = (): KnownModel => ({
  name: 'tiny',
  description: '',
  version: '1',
  licence: 'MIT',
  source: 'https://example.org',
  address: bucket.url,
  files: Object.entries(FILES).map(fileOf),
});

interface Options {
  readonly signal?: AbortSignal;
  readonly mirror?: string;
  readonly onProgress?: (bytes: number) => void;
  readonly stallMs?: number;
}
const download = ({ signal = new AbortController().signal, ...options }: Options = {}) =>
  downloadModel(model(), { folder, mirror: undefined, onProgress: () => {}, signal, ...options });
/** Everything in the folder of models. */
const left = (): string[] => readdirSync(folder);

describe('a download of a model [EX-58]', () => {
  it('is a complete asset set with a manifest', async () => {
    const told: number[] = [];
    await download({ onProgress: (bytes) => told.push(bytes) });
    expect(left()).toEqual(['tiny']);
    const assets = new AssetFolders([folder]);
    const manifest = await assets.manifest('tiny');
    expect(manifest).toMatchObject({ version: '1', licence: 'MIT', source: 'https://example.org' });
    for (const file of manifest.files) await assets.verify('tiny', file);
    expect(manifest.files).toEqual(model().files);
    expect(told.at(-1)).toBe(TOTAL_BYTES);
    expect(told).toEqual([...told].sort((a, b) => a - b));
  });

  it('comes from a mirror, whose folders are called as the sets', async () => {
    const mirror = await FakeBucket.open({
      'm/tiny/model.json': FILES['model.json'],
      'm/tiny/weights/part1': FILES['weights/part1'],
    });
    await download({ mirror: `${mirror.url}m/` });
    await mirror.close();
    expect(left()).toEqual(['tiny']);
    expect(bucket.asked).toEqual([]);
  });

  it('follows redirects within its host', async () => {
    const headers = { location: '/model.json' };
    bucket.answers.set('model.json', { status: 302, headers: { location: '/moved.json' } });
    bucket.answers.set('moved.json', { body: FILES['model.json'] });
    await download();
    expect(left()).toEqual(['tiny']);
    bucket.answers.set('model.json', { status: 302, headers });
    await expect(download()).rejects.toThrow('redirects more than 3 times');
  });

  it('replaces what is there, such as a damaged set', async () => {
    mkdirSync(join(folder, 'tiny'));
    writeFileSync(join(folder, 'tiny', 'model.json'), 'damaged');
    await download();
    expect(left()).toEqual(['tiny']);
    expect(readFileSync(join(folder, 'tiny', 'model.json'), 'utf8')).toBe('{"a":1}');
  });

  it('removes what a process left that ended during a download', async () => {
    // The largest process id of Linux is 2^22.
    mkdirSync(join(folder, `.download-${2 ** 22 + 1}-tiny`));
    mkdirSync(join(folder, `.download-${process.pid}-tiny`));
    mkdirSync(join(folder, '.download-1-tiny'));
    await download();
    expect(left().sort()).toEqual(['.download-1-tiny', 'tiny']);
  });

  const wrong: [string, BucketAnswer, string][] = [
    ['has another hash', { body: Buffer.from('{"a":2}') }, 'its SHA-256 differs'],
    ['is too long', { body: Buffer.from('{"a":1} ') }, 'it has more than 7 bytes'],
    ['is too short', { body: Buffer.from('{"a":') }, 'it has 5 bytes instead of 7'],
    ['is missing', { status: 404 }, 'answers with status 404'],
    ['is an error page', { status: 503, body: Buffer.from('{"a":1}') }, 'status 503'],
    ['is cut off', { body: Buffer.from('{"a"'), then: 'cut' }, 'could not be reached'],
    [
      'is elsewhere',
      { status: 302, headers: { location: 'http://127.0.0.1:1/model.json' } },
      'redirects to http://127.0.0.1:1, which is refused',
    ],
    ['stalls', { body: Buffer.from('{"a"'), then: 'silence' }, 'sent nothing for 0.2 s'],
  ];
  it.each(wrong)(
    'of a file that %s fails, and what was there stays',
    async (_name, answer, why) => {
      bucket.answers.set('model.json', answer);
      await expect(download({ stallMs: 200 })).rejects.toThrow(why);
      expect(left()).toEqual([]);
      mkdirSync(join(folder, 'tiny'));
      writeFileSync(join(folder, 'tiny', 'mine.json'), 'mine');
      await expect(download({ stallMs: 200 })).rejects.toThrow(why);
      expect(left()).toEqual(['tiny']);
      expect(readFileSync(join(folder, 'tiny', 'mine.json'), 'utf8')).toBe('mine');
    },
  );

  it('reads no more than the stated size of an endless file', async () => {
    const body = Buffer.alloc(64 * 1024 * 1024);
    bucket.answers.set('weights/part1', { body });
    let received = 0;
    await expect(download({ onProgress: (bytes) => (received = bytes) })).rejects.toThrow(
      'more than',
    );
    expect(received).toBeLessThanOrEqual(TOTAL_BYTES);
  });

  it('names the address that cannot be reached', async () => {
    const { url } = bucket;
    const unreachable = { ...model(), address: url };
    await bucket.close();
    const options = { folder, mirror: undefined, onProgress: () => {} };
    const { signal } = new AbortController();
    await expect(downloadModel(unreachable, { ...options, signal })).rejects.toThrow(
      `${url.slice(0, -1)} could not be reached: connect ECONNREFUSED`,
    );
    bucket = await FakeBucket.open({});
  });

  it('that is cancelled leaves nothing', async () => {
    bucket.answers.set('weights/part1', { body: Buffer.alloc(10), then: 'silence' });
    const abort = new AbortController();
    const onProgress = (bytes: number): void => {
      if (bytes === 17) abort.abort(new Error('cancelled'));
    };
    await expect(download({ signal: abort.signal, onProgress })).rejects.toThrow('cancelled');
    expect(left()).toEqual([]);
  });

  it('that cannot be written says so, without paths', async () => {
    rmSync(folder, { recursive: true });
    writeFileSync(folder, 'a file');
    await expect(download()).rejects.toThrow(
      /^The files could not be written into the data directory: E[A-Z]+\.$/,
    );
    expect(existsSync(join(folder, 'tiny'))).toBe(false);
  });
});
