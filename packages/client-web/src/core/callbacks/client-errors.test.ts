import { settle } from '@ubii/timing/testing';
import { describe, expect, it, vi } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import { wrongToken } from '../connection/join.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import type { IdentityStorage } from '../ports/identity-storage.ts';

const RECORD = { topic: '/a', format: 'int32', value: 1 } as const;

/** A client whose `onError` remembers the messages of errors, by source. */
async function setup(options: Parameters<typeof createTestClient>[1] = {}) {
  const master = new FakeMaster();
  const errors: string[] = [];
  const onError: ErrorHandler = (error, source) =>
    errors.push(`${source}: ${(error as Error).message}`);
  const test = createTestClient(master, { onError, ...options });
  await test.client.connect();
  await settle();
  return { master, errors, ...test };
}

function fail(message: string): never {
  throw new Error(message);
}

describe('errors of callbacks', () => {
  it('go to onError, and neither records nor the connection are lost', async () => {
    const { master, client, errors, clock } = await setup();
    const values: unknown[] = [];
    client.subscribe('/a').onRecord(() => fail('record'));
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    client.onState(() => fail('state'));
    client.onRoundTrip(() => fail('round trip'));
    client.masterTime.onEstimate(() => fail('estimate'));
    client.onError(() => fail('problem'));
    await settle();
    master.publish(RECORD);
    await settle();
    master.drop();
    await clock.advance(1_000);
    expect(values).toEqual([1, 1]); // the second one is the retained record
    expect(client.state.status).toBe('connected');
    expect(new Set(errors)).toEqual(
      new Set(['listener: record', 'listener: state', 'listener: round trip']),
    );
  });

  it('go to onError from asynchronous callbacks, too', async () => {
    const { master, client, errors } = await setup();
    const onRecord = (): unknown => settle().then(() => fail('record'));
    client.subscribe('/a').onRecord(onRecord);
    await settle();
    master.publish(RECORD);
    await settle();
    await settle();
    expect(errors).toEqual(['listener: record']);
  });

  it.each<[string, () => unknown]>([
    ['throw', () => fail('mine')],
    ['reject', () => Promise.reject(new Error('mine'))],
  ])('go to onError from receivers of encoded records that %s', async (_how, onRecord) => {
    const { master, client, errors } = await setup();
    const values: unknown[] = [];
    client.subscribeEncoded('/a', { onRecord, onGone: onRecord });
    client.subscribe('/a').onRecord(({ value }) => values.push(value));
    await settle();
    master.publish(RECORD);
    master.publish({ topic: '/a' });
    await settle();
    expect(values).toEqual([1]);
    expect(errors).toEqual(['listener: mine', 'listener: mine']);
  });

  it('go to the default handler when onError itself fails', async () => {
    const reported = vi.fn();
    process.once('unhandledRejection', reported); // what the default of a test client does
    const { client, clock, master } = await setup({ onError: () => fail('handler') });
    client.onState(() => fail('state'));
    master.drop();
    await clock.advance(10);
    expect(reported.mock.calls.map(([error]) => String(error))).toEqual(['Error: handler']);
  });

  it('can be reported by libraries', async () => {
    const { client, errors } = await setup();
    client.reportError(new Error('of a library'), 'listener');
    expect(errors).toEqual(['listener: of a library']);
  });
});

describe('errors of the identity storage', () => {
  const works: Required<IdentityStorage> = {
    load: () => undefined,
    save: () => undefined,
    loadCredential: () => undefined,
    forgetCredential: () => undefined,
  };

  it.each<[string, Partial<IdentityStorage>]>([
    ['load', { load: () => fail('mine') }],
    ['load, later', { load: () => Promise.reject(new Error('mine')) }],
    ['save', { save: () => fail('mine') }],
    ['save, later', { save: () => Promise.reject(new Error('mine')) as unknown as undefined }],
    ['loadCredential', { loadCredential: () => fail('mine') }],
  ])('go to onError, and the client connects: %s', async (_member, broken) => {
    const { client, errors } = await setup({ identity: { ...works, ...broken } });
    expect(client.state.status).toBe('connected');
    expect(errors).toEqual(['identity-storage: mine']);
  });

  it('go to onError, and the client registers without the refused credential: forgetCredential', async () => {
    const master = new FakeMaster();
    let refusals = 0;
    master.onRequest = ({ topic }) => {
      if (!topic.endsWith('/registration') || refusals > 0) return undefined;
      refusals += 1;
      return wrongToken();
    };
    const errors: unknown[] = [];
    const { client } = createTestClient(master, {
      identity: { ...works, loadCredential: () => 'old', forgetCredential: () => fail('mine') },
      onError: (error, source) => errors.push([source, String(error)]),
    });
    await client.connect();
    expect(client.state.status).toBe('connected');
    expect(errors).toEqual([['identity-storage', 'Error: mine']]);
  });
});
