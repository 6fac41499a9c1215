import { randomBytes } from 'node:crypto';
import { Kvm } from '@nats-io/kv';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { documentStoreSuite, Inbox } from '../../testing/acceptance/index.ts';
import { openNatsBench, type NatsBench } from '../../testing/nats-bench.ts';
import { encodeKey } from './key-names.ts';
import { NatsDocuments } from './nats-documents.ts';

const BUCKET = 'ubii_test_sessions';

documentStoreSuite('NatsDocuments', async () => {
  const bench = await openNatsBench();
  const { link } = await bench.openLink();
  const store = await NatsDocuments.open(link, BUCKET);
  const other = await bench.openLink();
  const kv = await new Kvm(other.link.connection).open(BUCKET);
  return {
    store,
    async edit(key, text) {
      const before = store.documents();
      const noticed = new Promise<void>((resolve) => {
        const cancel = store.onChange(() => {
          cancel();
          resolve();
        });
      });
      if (text === undefined) await kv.delete(encodeKey(key));
      else await kv.put(encodeKey(key), text);
      await noticed;
      if (store.documents() === before) throw new Error('the map is the same');
    },
    reopen: () => NatsDocuments.open(link, BUCKET),
    end: () => bench.close(),
  };
});

describe('[CU-54] documents in NATS', () => {
  let bench: NatsBench;
  const opened: NatsDocuments[] = [];
  beforeEach(async () => {
    bench = await openNatsBench();
  });
  afterEach(async () => {
    for (const store of opened.splice(0)) store.close();
    await bench.close();
  });

  async function open() {
    const link = await bench.openLink();
    const store = await NatsDocuments.open(link.link, BUCKET);
    opened.push(store);
    return { ...link, store };
  }
  const changed = (store: NatsDocuments, isDone: () => boolean): Promise<void> =>
    new Promise((resolve) => {
      const cancel = store.onChange(() => {
        if (!isDone()) return;
        cancel();
        resolve();
      });
    });
  const keys = (store: NatsDocuments): string[] => [...store.documents().keys()];

  it('reach every master, and are told to all but the one that wrote', async () => {
    const [a, b] = [await open(), await open()];
    const toldA: string[] = [];
    a.store.onChange((told) => toldA.push(...told));
    const heard = changed(b.store, () => b.store.documents().size === 2);
    await Promise.all([a.store.write('one', { n: 1 }), a.store.write('two', { n: 2 })]);
    await heard;
    expect(toldA).toEqual([]);
    const back = changed(a.store, () => toldA.length === 2);
    await b.store.write('one', { n: 3 });
    await b.store.delete('two');
    await back;
    expect(toldA).toEqual(['one', 'two']);
    expect([...a.store.documents()]).toEqual([['one', { json: { n: 3 } }]]);
  });

  it('are compressed when they are large, and refused when that does not suffice', async () => {
    const [a, b] = [await open(), await open()];
    const code = 'state.count += 1; // again and again\n'.repeat(100_000);
    const heard = changed(b.store, () => b.store.documents().size === 1);
    await a.store.write('large', { code });
    await heard;
    expect(b.store.documents().get('large')).toEqual({ json: { code } });
    const noise = randomBytes(1_100_000).toString('base64');
    await expect(a.store.write('too large', { noise })).rejects.toThrow(/Raise max_payload/);
    expect(keys(a.store)).toEqual(['large']);
  });

  it('of compressed junk have a fault', async () => {
    const { store, link } = await open();
    const kv = await new Kvm(link.connection).open(BUCKET);
    const heard = changed(store, () => store.documents().size === 1);
    await kv.put('not a key of ours'.replaceAll(' ', '.'), '{}');
    await kv.put('junk', Uint8Array.of(0x1f, 0x8b, 1, 2, 3));
    await heard;
    expect([...store.documents()]).toEqual([['junk', { fault: expect.any(String) }]]);
  });

  it('cannot be written while NATS is away, which is said at once', async () => {
    const { store, link, cut } = await open();
    await store.write('kept', { n: 1 });
    const lost = new Promise<void>((resolve) => link.onReach(() => resolve()));
    cut();
    await lost;
    await expect(store.write('lost', {})).rejects.toThrow(/NATS cannot be reached/);
    await expect(store.delete('kept')).rejects.toThrow(/NATS cannot be reached/);
    expect(keys(store)).toEqual(['kept']);
  });

  it('[CU-53] that changed while a master was away are told when it is back', async () => {
    const [a, b] = [await open(), await open()];
    await Promise.all(['changed', 'kept', 'removed'].map((key) => a.store.write(key, { n: 1 })));
    const told: string[] = [];
    const lost = new Promise<void>((resolve) => a.link.onReach(() => resolve()));
    a.cut();
    await lost;
    a.store.onChange((changes) => told.push(...changes));
    await b.store.write('changed', { n: 2 });
    await b.store.delete('removed');
    await b.store.write('added', { n: 1 });
    const back = changed(a.store, () => told.length === 3);
    a.heal();
    await back;
    expect(told.sort()).toEqual(['added', 'changed', 'removed']);
    expect(keys(a.store)).toEqual(['added', 'changed', 'kept']);
  });

  it('[CU-53] survive kill -9 of NATS, and are written back when its storage is lost', async () => {
    const { store, link } = await open();
    for (let n = 0; n < 5; n += 1) await store.write('often', { n });
    await store.write('once', { n: 1 });
    const reach = new Inbox<boolean>();
    link.onReach((isConnected) => reach.add(isConnected));
    await bench.server.kill();
    await bench.server.restart();
    expect([await reach.next(), await reach.next()]).toEqual([false, true]);
    await store.write('after', {});
    expect(keys(store)).toEqual(['after', 'often', 'once']);

    const other = await open();
    await other.store.delete('once');
    await vi.waitFor(() => expect(keys(store)).toEqual(['after', 'often']));
    await bench.server.kill();
    await bench.server.empty();
    await bench.server.restart();
    await reach.next();
    await reach.next();
    // Both masters wrote back what they had: a third one, which had nothing, finds it.
    await vi.waitFor(
      async () => expect(keys((await open()).store)).toEqual(['after', 'often']),
      10_000,
    );
    expect(keys(store)).toEqual(['after', 'often']);
    await store.write('often', { n: 99 });
    expect(keys((await open()).store)).toEqual(['after', 'often']);
  });
});
