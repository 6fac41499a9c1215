import { expect, it, onTestFinished } from 'vitest';

import { ownerStoreSuite } from '../../testing/acceptance/index.ts';
import { openNatsBench, type CuttableLink } from '../../testing/nats-bench.ts';
import { KvBucket } from './kv-bucket.ts';
import { NatsOwners } from './nats-owners.ts';

ownerStoreSuite('NatsOwners', async () => {
  const bench = await openNatsBench();
  const links: CuttableLink[] = [];
  return {
    async open() {
      const opened = await bench.openLink();
      links.push(opened);
      return NatsOwners.open(opened.link, 'ubii_test_owners');
    },
    async setFirstReachable(isReachable) {
      const [{ link, cut, heal }] = links as [CuttableLink];
      if (isReachable) return heal();
      const lost = new Promise<void>((resolve) => link.onReach(() => resolve()));
      cut();
      await lost;
    },
    close: () => bench.close(),
  };
});

it('[CU-57] forgets deletions only, and takes claims after that', async () => {
  const bench = await openNatsBench();
  onTestFinished(() => bench.close());
  const { link } = await bench.openLink();
  const bucket = new KvBucket(link, 'ubii_test_owners');
  const owners = await NatsOwners.open(link, bucket.name);
  onTestFinished(() => owners.close());
  for (const key of ['gone', 'back']) {
    await owners.claim(key, 'A', undefined);
    await owners.release(key, 'A');
  }
  const revisions = {
    gone: (await bucket.read('gone'))!.revision,
    back: (await bucket.read('back'))!.revision,
  };
  await owners.claim('back', 'B', undefined);
  await bucket.forget('gone', revisions.gone);
  await bucket.forget('back', revisions.back);
  expect(await bucket.read('gone')).toBeUndefined();
  expect([...owners.owners()]).toEqual([['back', 'B']]);
  expect(await owners.claim('back', 'C', 'B')).toBe(true);
  expect(await owners.claim('gone', 'C', undefined)).toBe(true);
});
