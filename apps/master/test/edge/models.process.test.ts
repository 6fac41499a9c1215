import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { AssetSetState, type AssetSet, type JsonObject } from '@ubii/proto';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import type { KnownModel } from '../../src/adapters/models/catalogue.ts';
import { FakeBucket } from '../../src/testing/fake-bucket.ts';
import { send, startEdgeMaster, type EdgeMasterOptions } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

const CONTENT = Buffer.from('{"model":1}');

/** A master that knows one model, which a bucket on loopback has. */
async function setUp(options: EdgeMasterOptions = {}) {
  const bucket = await FakeBucket.open({ 'model.json': CONTENT });
  onTestFinished(() => bucket.close());
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
  const dataDir = temporaryFolder();
  const master = await startEdgeMaster({ dataDir, models: [model], ...options });
  const call = async (service: string, name?: string): Promise<JsonObject> => {
    const topic = `/services/ubii/${service}`;
    const { body } = await send(master.port, '/services/json', {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: JSON.stringify({ topic, ...(name !== undefined && { assetSetRequest: { name } }) }),
    });
    return JSON.parse(body.toString()) as JsonObject;
  };
  const tiny = async (): Promise<AssetSet> => {
    const { assetSetList } = (await call('asset_set_list')) as unknown as {
      assetSetList: { elements: AssetSet[] };
    };
    return assetSetList.elements.find(({ name }) => name === 'tiny')!;
  };
  /** Asks until nothing is under way. */
  const settled = async (): Promise<AssetSet> => {
    for (;;) {
      const set = await tiny();
      if (set.download?.running !== true) return set;
    }
  };
  return { bucket, dataDir, models: join(dataDir, 'models'), master, call, tiny, settled };
}

const state = ({ state: one }: AssetSet): unknown =>
  typeof one === 'string' ? AssetSetState[one as keyof typeof AssetSetState] : one;

describe('models of a master [EX-57] [EX-58]', () => {
  it('are downloaded on request, and modules can load them without a restart', async () => {
    const { call, tiny, settled, master, models } = await setUp();
    const before = await tiny();
    expect(state(before)).toBe(AssetSetState.ASSET_SET_STATE_MISSING);
    expect(before).toMatchObject({ licence: 'MIT', bytes: CONTENT.length });
    expect(before.folder).toBe(join(models, 'tiny'));
    await call('asset_set_download', 'tiny');
    const after = await settled();
    expect(state(after)).toBe(AssetSetState.ASSET_SET_STATE_PRESENT);
    expect(after).toMatchObject({ version: '1', source: 'https://example.org' });
    const { status, body } = await send(master.port, '/asset-sets/tiny/manifest.json');
    expect(status).toBe(200);
    expect(JSON.parse(body.toString())).toMatchObject({ name: 'tiny', licence: 'MIT' });
    expect(await call('asset_set_download', 'tiny')).toMatchObject({
      error: { code: 'already_exists' },
    });
  });

  it('are downloaded once for all that ask at the same time, and report progress', async () => {
    const { bucket, call, tiny, settled } = await setUp();
    let answer!: () => void;
    bucket.onRequest = () => new Promise((resolve) => (answer = resolve));
    await Promise.all([call('asset_set_download', 'tiny'), call('asset_set_download', 'tiny')]);
    expect((await tiny()).download).toMatchObject({ running: true, totalBytes: CONTENT.length });
    await expect.poll(() => bucket.asked.length).toBeGreaterThan(0);
    answer();
    expect(state(await settled())).toBe(AssetSetState.ASSET_SET_STATE_PRESENT);
    expect(bucket.asked).toEqual(['model.json']);
  });

  it('that are cancelled leave nothing, and can be downloaded again', async () => {
    const { bucket, call, settled, models } = await setUp();
    bucket.answers.set('model.json', { body: CONTENT.subarray(0, 3), then: 'silence' });
    await call('asset_set_download', 'tiny');
    await expect.poll(() => bucket.asked.length).toBeGreaterThan(0);
    await call('asset_set_cancel', 'tiny');
    expect((await settled()).download).toBeUndefined();
    expect(readdirSync(models)).toEqual([]);
    bucket.answers.clear();
    await call('asset_set_download', 'tiny');
    expect(state(await settled())).toBe(AssetSetState.ASSET_SET_STATE_PRESENT);
  });

  it('say why they could not be downloaded', async () => {
    const { bucket, call, settled } = await setUp();
    bucket.answers.set('model.json', { body: Buffer.from('{"model":2}') });
    await call('asset_set_download', 'tiny');
    const failed = await settled();
    expect(failed.download?.error).toContain('its SHA-256 differs');
    bucket.answers.clear();
    await call('asset_set_download', 'tiny');
    expect((await settled()).download).toBeUndefined();
  });

  it('that a person put there are recognised, damaged ones as well', async () => {
    const { tiny, models, call, settled } = await setUp();
    const folder = join(models, 'tiny');
    mkdirSync(folder, { recursive: true });
    writeFileSync(join(folder, 'model.json'), CONTENT);
    const published = await tiny();
    expect(state(published)).toBe(AssetSetState.ASSET_SET_STATE_PRESENT);
    expect(published).toMatchObject({ version: '1', licence: 'MIT' });
    writeFileSync(join(folder, 'model.json'), 'my own');
    const own = await tiny();
    expect(state(own)).toBe(AssetSetState.ASSET_SET_STATE_PRESENT);
    expect(own.version ?? '').toBe('');
    writeFileSync(join(folder, 'manifest.json'), '{');
    const damaged = await tiny();
    expect(state(damaged)).toBe(AssetSetState.ASSET_SET_STATE_DAMAGED);
    expect(damaged.problem).toContain('is not valid JSON');
    await call('asset_set_download', 'tiny');
    expect(state(await settled())).toBe(AssetSetState.ASSET_SET_STATE_PRESENT);
  });

  it('that are unknown cannot be downloaded', async () => {
    const { call } = await setUp();
    for (const name of ['other', '../tiny', '']) {
      expect(await call('asset_set_download', name)).toMatchObject({
        error: { code: 'not_found' },
      });
    }
  });

  it('are not left half when the master ends', async () => {
    const { bucket, call, master, models } = await setUp();
    bucket.answers.set('model.json', { body: CONTENT.subarray(0, 3), then: 'silence' });
    await call('asset_set_download', 'tiny');
    await expect.poll(() => bucket.asked.length).toBeGreaterThan(0);
    await master.close();
    expect(existsSync(models) ? readdirSync(models) : []).toEqual([]);
  });
});
