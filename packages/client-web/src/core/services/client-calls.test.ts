import { SERVICES, ServiceError } from '@ubii/proto';
import type { ServiceRequest } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { FakeMaster } from '../../testing/fake-master.ts';
import { createMemoryServices } from '../../transports/memory.ts';
import { ClientCalls } from './client-calls.ts';
import { isUnknownClient } from '../connection/link-failure.ts';
import { ServiceCalls } from './service-calls.ts';

/** The calls of a client that the master takes for ada. */
function setup({ isExtended = true, isKnown = true, isConnected = true } = {}) {
  const clock = new FakeClock();
  const master = new FakeMaster();
  const calls = new ClientCalls({
    calls: new ServiceCalls(createMemoryServices(master), clock, 1_000),
    clock,
    timeoutMs: 1_000,
    connection: () => ({
      state: isConnected
        ? ({ status: 'connected' } as never)
        : { status: 'connecting', attempt: 1 },
      whenConnected: () => new Promise<void>(() => undefined),
    }),
    registration: {
      clientId: 'ada',
      membership: { isExtended } as never,
      isKnown: () => Promise.resolve(isKnown),
    },
  });
  const asked = (): ServiceRequest => master.requests.at(-1)!;
  return { clock, master, calls, asked };
}

describe('ClientCalls', () => {
  it('adds its client id to requests with such a field, and keeps the id of the caller', async () => {
    const { master, calls, asked } = setup();
    master.services.set(SERVICES.clientRename.topic, () => ({ client: { id: 'ben' } }));
    await calls.callNow('clientRename', { targetId: 'ben', name: 'Ben' });
    expect(asked().clientRenameRequest?.clientId).toBe('ada');
    await calls.callNow('clientRename', { clientId: 'eva', targetId: 'ben', name: 'Ben' });
    expect(asked().clientRenameRequest?.clientId).toBe('eva');
  });

  it('takes a client id elsewhere for a criterion', async () => {
    const { calls, asked } = setup();
    await calls.callNow('componentGetList', { elements: [{ name: 'touch' }] });
    expect(JSON.stringify(asked())).not.toContain('ada');
    expect(JSON.stringify(asked())).toContain('touch');
  });

  it('waits for the connection as part of the time-out', async () => {
    const { clock, master, calls } = setup({ isConnected: false });
    const called = calls.call('topicList', undefined).catch((error: unknown) => error);
    await clock.advance(1_000);
    expect(await called).toMatchObject({ name: 'ConnectionError', reason: 'timeout' });
    expect(master.requests).toEqual([]);
  });

  it.each([
    ['one of ours', { isExtended: true, isKnown: false }, false],
    ['an original one that knows the client', { isExtended: false, isKnown: true }, false],
    ['an original one that does not', { isExtended: false, isKnown: false }, true],
  ])('asks whether the client is known when %s refuses', async (_master, options, isUnknown) => {
    const { master, calls } = setup(options);
    master.onRequest = () => new ServiceError('internal', 'no');
    const error = await calls
      .callAsMember('deviceRegistration', {})
      .catch((cause: unknown) => cause);
    expect(isUnknownClient(error)).toBe(isUnknown);
  });
});
