import { afterAll, beforeAll, describe, expect, it, vi } from 'vitest';

import { openNatsBench, type NatsBench } from '../../testing/nats-bench.ts';
import { keepClusterKey, readOrCreateClusterKey } from './cluster-key.ts';
import { KvBucket } from './kv-bucket.ts';
import type { NatsLink } from './nats-link.ts';

describe('[CU-56] the key of a cluster', () => {
  let bench: NatsBench;
  let link: NatsLink;
  beforeAll(async () => {
    bench = await openNatsBench();
    ({ link } = await bench.openLink());
  });
  afterAll(() => bench.close());

  it('is made once, also by masters that start at once, and survives kill -9 of NATS', async () => {
    const bucket = 'ubii_test_keys';
    const read = () => readOrCreateClusterKey(link, bucket);
    const [key, ...others] = await Promise.all([read(), read(), read()]);
    expect(key).toHaveLength(32);
    expect(others).toEqual([key, key]);
    const isBack = new Promise<void>((resolve) => {
      link.onReach((isConnected) => isConnected && resolve());
    });
    await bench.server.kill();
    await bench.server.restart();
    await isBack;
    expect(await read()).toEqual(key);
    expect(await readOrCreateClusterKey(link, 'ubii_other_keys')).not.toEqual(key);
  });

  it('is made again after it was deleted', async () => {
    const bucket = 'ubii_deleted_keys';
    const key = await readOrCreateClusterKey(link, bucket);
    await new KvBucket(link, bucket).write('token-key', undefined);
    expect(await readOrCreateClusterKey(link, bucket)).not.toEqual(key);
  });

  it('is written back when NATS lost its storage, and not when it was deleted', async () => {
    const bucket = 'ubii_kept_keys';
    const key = await readOrCreateClusterKey(link, bucket);
    const cancel = keepClusterKey(link, bucket, key);
    const again = new KvBucket(link, bucket);
    await bench.server.kill();
    await bench.server.empty();
    await bench.server.restart();
    const stored = await vi.waitFor(async () => {
      const entry = await again.read('token-key');
      expect(entry).toBeDefined();
      return entry!;
    }, 10_000);
    expect(Buffer.from(stored.value!).toString()).toBe(Buffer.from(key).toString('hex'));
    await again.write('token-key', undefined);
    const isBack = new Promise<void>((resolve) => {
      link.onReach((isConnected) => isConnected && resolve());
    });
    await bench.server.kill();
    await bench.server.restart();
    await isBack;
    await again.ensure();
    expect((await again.read('token-key'))?.value).toBeUndefined();
    cancel();
  });

  it('is never guessed from something else', async () => {
    const bucket = new KvBucket(link, 'ubii_damaged_keys');
    await bucket.ensure();
    await bucket.write('token-key', Buffer.from('short'));
    await expect(readOrCreateClusterKey(link, bucket.name)).rejects.toThrow(
      /ubii_damaged_keys of NATS must hold 32 bytes .* Delete it/,
    );
  });
});
