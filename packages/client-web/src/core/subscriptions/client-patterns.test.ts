import { LazyPatterns, type PatternCompiler } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import type { RecordInit } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import { Deferred } from '../callbacks/deferred.ts';

const int32 = (topic: string, value: number): RecordInit => ({ topic, format: 'int32', value });

/** A client whose compiler of patterns comes when the test says so. */
async function setup() {
  const master = new FakeMaster();
  const loading = new Deferred<PatternCompiler>();
  const patterns = new LazyPatterns(() => loading.promise);
  const all = createTestClient(master, { patterns });
  await all.client.connect();
  return { master, loading, ...all };
}

describe('a regular expression while its engine is loaded [TD-64]', () => {
  it('is asked for afterwards', async () => {
    const { master, client, loading } = await setup();
    const values: unknown[] = [];
    const subscription = client.subscribe({ regex: '^/a/' });
    subscription.onRecord(({ value }) => values.push(value));
    await settle();
    expect(master.holds(client.id).regexes).toEqual([]);
    loading.resolve(new Re2Patterns());
    await subscription.ready;
    master.publish(int32('/a/y', 2));
    master.publish(int32('/b', 3));
    await settle();
    expect(master.holds(client.id).regexes).toEqual(['^/a/']);
    expect(values).toEqual([2]);
  });

  it('is asked for once, with all who wanted it meanwhile', async () => {
    const { master, client, loading } = await setup();
    const values: unknown[] = [];
    const subscriptions = [1, 2].map(() =>
      client.subscribe({ regex: '^/a/' }).onRecord(({ value }) => values.push(value)),
    );
    loading.resolve(new Re2Patterns());
    await Promise.all(subscriptions.map(({ ready }) => ready));
    master.publish(int32('/a/x', 1));
    await settle();
    expect(values).toEqual([1, 1]);
  });

  it('is removed with its last subscription', async () => {
    const { master, client, loading } = await setup();
    const subscription = client.subscribe({ regex: '^/a/' });
    const refused = expect(subscription.ready).rejects.toThrow('closed');
    await subscription.close();
    loading.resolve(new Re2Patterns());
    await refused;
    await settle();
    expect(master.holds(client.id).regexes).toEqual([]);
  });

  it('ends with the reason when it is none', async () => {
    const { client, loading, problems } = await setup();
    const subscription = client.subscribe({ regex: '(a)\\1' });
    const refused = expect(subscription.ready).rejects.toThrow('back-references');
    loading.resolve(new Re2Patterns());
    await refused;
    expect(problems).toMatchObject([{ code: 'invalid_argument' }]);
  });

  it('ends when the engine cannot be had; the next one tries again', async () => {
    const master = new FakeMaster();
    let attempts = 0;
    const patterns = new LazyPatterns(() => {
      attempts += 1;
      return attempts === 1
        ? Promise.reject(new Error('no network'))
        : Promise.resolve(new Re2Patterns());
    });
    const { client, problems } = createTestClient(master, { patterns });
    await client.connect();
    await expect(client.subscribe({ regex: 'a' }).ready).rejects.toThrow('no network');
    expect(problems).toMatchObject([{ code: 'unavailable' }]);
    await client.subscribe({ regex: 'a' }).ready;
    expect(master.holds(client.id).regexes).toEqual(['a']);
  });
});

describe('an expression that stalls others [TD-60]', () => {
  it('does not stop the records of a client', async () => {
    const { master, client, loading } = await setup();
    loading.resolve(new Re2Patterns());
    const values: unknown[] = [];
    const hostile = client.subscribe({ regex: '(a+)+$' });
    const all = client.subscribe({ glob: '/**' }).onRecord(({ value }) => values.push(value));
    await Promise.all([hostile.ready, all.ready]);
    master.publish(int32(`/${'a'.repeat(1000)}!`, 7));
    await settle();
    expect(values).toEqual([7]);
  });
});
