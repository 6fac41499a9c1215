import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { FakeBucket } from '../../testing/fake-bucket.ts';
import type { KnownModel } from './catalogue.ts';
import { runModels, type ModelProgram } from './model-program.ts';

const CONTENT = Buffer.alloc(2_000_000, 1);

let bucket: FakeBucket;
let dataDir: string;
beforeEach(async () => {
  dataDir = temporaryFolder();
  bucket = await FakeBucket.open({ 'model.json': CONTENT, 'mirror/tiny/model.json': CONTENT });
});
afterEach(() => bucket.close());

async function run(args: readonly string[], changes: Partial<ModelProgram> = {}) {
  const model: KnownModel = {
    name: 'tiny',
    description: 'A tiny model.',
    version: '1',
    licence: 'MIT',
    source: 'https://example.org',
    address: bucket.url,
    files: [
      {
        path: 'model.json',
        bytes: CONTENT.length,
        sha256: createHash('sha256').update(CONTENT).digest('hex'),
      },
    ],
  };
  let output = '';
  let nowMs = 0;
  const write = (text: string): void => void (output += text);
  const code = await runModels([...args, '--data-dir', dataDir], {
    models: [model],
    assetsFolder: join(dataDir, 'none'),
    env: {},
    cwd: '/',
    signal: new AbortController().signal,
    isTerminal: false,
    write,
    writeError: write,
    nowMs: () => (nowMs += 100),
    ...changes,
  });
  return { code, output };
}
const left = (): string[] => readdirSync(join(dataDir, 'models'));

describe('npm run models [EX-59]', () => {
  it('lists models, what is installed, and how to get the others', async () => {
    const before = await run([]);
    expect(before.code).toBe(0);
    expect(before.output).toContain('tiny  not installed    2.0 MB  A tiny model.\n');
    expect(before.output).toContain('npm run models -- get tiny');
    await run(['get', 'tiny']);
    const { output } = await run(['list']);
    expect(output).toContain('tiny  installed');
    expect(output).not.toContain('-- get');
    expect(output).toContain(`Models are installed in ${join(dataDir, 'models')}.`);
  });

  it('downloads a model, and says how far it is', async () => {
    const { code, output } = await run(['get', 'tiny']);
    expect(code).toBe(0);
    expect(output).toContain(`Downloading tiny (2.0 MB, MIT) from ${bucket.url}`);
    expect(output).toMatch(/\n 1\d % {2}0\.\d of 2\.0 MB {2}\d+ s left\n/);
    expect(output).toContain('100 %  2.0 of 2.0 MB');
    expect(output).toContain(
      `tiny is verified and installed in ${join(dataDir, 'models', 'tiny')}.`,
    );
    const again = await run(['get', 'tiny']);
    expect(again).toMatchObject({
      code: 0,
      output: expect.stringContaining('tiny is installed in'),
    });
    expect(bucket.asked).toEqual(['model.json']);
  });

  it('shows progress in one line of a terminal', async () => {
    const { output } = await run(['get', 'tiny'], { isTerminal: true });
    expect(output).toMatch(/\r100 % {2}2\.0 of 2\.0 MB {2}0 s left/);
    expect(output).toContain('\u001b[K\n');
  });

  it('downloads from a mirror', async () => {
    await run(['get', 'tiny', '--model-mirror', `${bucket.url}mirror`]);
    expect(bucket.asked).toEqual(['mirror/tiny/model.json']);
    expect(left()).toEqual(['tiny']);
  });

  it('installs again what is damaged', async () => {
    mkdirSync(join(dataDir, 'models', 'tiny'), { recursive: true });
    writeFileSync(join(dataDir, 'models', 'tiny', 'model.json'), 'damaged');
    await run(['get', 'tiny']);
    expect((await run([])).output).toContain('tiny  installed        2.0 MB');
  });

  it('says what to do when the publisher cannot be reached', async () => {
    const { url } = bucket;
    await bucket.close();
    const { code, output } = await run(['get', 'tiny', '--model-mirror', url]);
    expect(code).toBe(1);
    expect(output).toContain(`${url.slice(0, -1)} could not be reached: connect ECONNREFUSED`);
    expect(output).toContain(
      `download model.json of ${url} on another machine, and put them into ${join(dataDir, 'models', 'tiny')}`,
    );
    expect(output).toContain('--model-mirror <url>');
    bucket = await FakeBucket.open({});
  });

  it('ends when it is interrupted, and keeps nothing', async () => {
    bucket.answers.set('model.json', { body: Buffer.alloc(10), then: 'silence' });
    const abort = new AbortController();
    bucket.onRequest = () => abort.abort();
    const { code, output } = await run(['get', 'tiny'], { signal: abort.signal });
    expect([code, output.split('\n').at(-2)]).toEqual([
      130,
      'Cancelled. The downloaded files were deleted.',
    ]);
    expect(left()).toEqual([]);
  });

  it.each([
    [['get', 'other'], 'No model is named "other". Available models: tiny.'],
    [['get'], 'Unexpected arguments: get.'],
    [['get', 'tiny', 'more'], 'Unexpected arguments: get tiny more.'],
    [['remove', 'tiny'], 'npm run models -- get <name>'],
  ])('refuses %j', async (args, message) => {
    const { code, output } = await run(args);
    expect(code).toBe(1);
    expect(output).toContain(message);
    expect(existsSync(join(dataDir, 'models'))).toBe(false);
  });

  it('takes its options as the master does', async () => {
    await expect(run(['get', 'tiny', '--nonsense'])).rejects.toThrow('Unknown flag --nonsense');
    const mirror = ['--model-mirror', 'ftp://example.org'];
    await expect(run(['get', 'tiny', ...mirror])).rejects.toThrow(
      'The option --model-mirror must be an address, such as http://10.0.0.7/models/, but is "ftp://example.org"',
    );
    expect(await run(['--help'])).toMatchObject({ code: 0 });
  });
});
