// @vitest-environment happy-dom
import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ClientState, ServiceError, type Client } from '@ubii/proto';
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, nextTick, ref, watch, type EffectScope } from 'vue';
import { createClientsStore } from './clients-store.ts';
import { createNodesStore } from './nodes-store.ts';
import { createMasterStatusStore } from './master-status-store.ts';
import { createTopicStatisticsStore } from './topic-statistics-store.ts';

const person = (id: string, state: Client['state'] = ClientState.ACTIVE): Client =>
  ({ id, name: id, state }) as unknown as Client;

/** Fake client with a master whose replies the test sets. */
function fakeClient() {
  const call = vi.fn<(service: string, request?: object) => Promise<unknown>>();
  let announce: (record: { value: Client }) => void = () => undefined;
  const subscribe = vi.fn(() => ({
    onRecord: (fn: typeof announce) => {
      announce = fn;
    },
  }));
  return {
    client: { call, subscribe } as unknown as UbiiClient,
    call,
    subscribe,
    announce: (value: Client) => announce({ value }),
  };
}

let scope: EffectScope;
beforeEach(() => {
  vi.useFakeTimers();
  scope = effectScope();
});
afterEach(() => {
  scope.stop();
  vi.useRealTimers();
});

/** Lets replies arrive and the next frame run. */
async function settle(): Promise<void> {
  await vi.advanceTimersByTimeAsync(20);
  await nextTick();
}

describe('clients store', () => {
  function setup(...lists: Client[][]) {
    const fake = fakeClient();
    for (const elements of lists) fake.call.mockResolvedValueOnce({ elements });
    fake.call.mockResolvedValue({ elements: lists.at(-1) ?? [] });
    const isConnected = ref(true);
    const store = scope.run(() => createClientsStore(fake.client, isConnected))!;
    const names = () => store.list.value?.map(({ id, state }) => `${id} ${state}`);
    return { ...fake, store, names, isConnected };
  }

  it('gives clients of the same name display names of their own, and keeps what they call themselves', async () => {
    const named = (id: string, name: string) => ({ ...person(id), name });
    const { store, announce } = setup([named('a', 'Phone'), named('b', 'Phone')]);
    await settle();
    expect(store.list.value?.map(({ name }) => name)).toEqual(['Phone', 'Phone 2']);
    expect(store.find('b')?.name).toBe('Phone 2');
    expect(store.ownName('b')).toBe('Phone');
    const before = store.find('b');
    announce(named('c', 'Phone'));
    await settle();
    expect(store.list.value?.map(({ name }) => name)).toEqual(['Phone', 'Phone 2', 'Phone 3']);
    // Views compare clients by identity.
    expect(store.find('b')).toBe(before);
  });

  it('keeps what an announcement leaves out, and asks for it once when it changed [EX-74]', async () => {
    const devices = [{ name: 'pen' }] as Client['devices'];
    const { store, announce, call } = setup([{ ...person('a'), devices }]);
    await settle();
    const abridged = (name: string, registrationRevision: number) =>
      announce({
        ...person('a'),
        name,
        devices: [],
        extension: { abridged: true, registrationRevision } as Client['extension'],
      } as Client);
    abridged('Ada', 3);
    abridged('Eve', 3);
    abridged('Eve', 4);
    await settle();
    expect(store.find('a')).toMatchObject({ name: 'Eve', devices: [{ name: 'pen' }] });
    expect(call).toHaveBeenCalledTimes(1);
    await vi.advanceTimersByTimeAsync(2_000);
    expect(call).toHaveBeenCalledTimes(2);
    expect(call).toHaveBeenLastCalledWith('clientGetList', { elements: [{ id: 'a' }] });
    abridged('Ada', 4);
    await vi.advanceTimersByTimeAsync(5_000);
    expect(call).toHaveBeenCalledTimes(2);
  });

  it('starts with the list, then follows what is announced [CL-31]', async () => {
    const { store, names, announce, subscribe } = setup([person('a')]);
    expect(store.list.value).toBeUndefined();
    expect(subscribe).toHaveBeenCalledWith({ glob: '/ubii/client/*' }, { format: 'client' });
    await settle();
    expect(names()).toEqual(['a 0']);
    announce(person('b'));
    announce(person('a', ClientState.INACTIVE));
    await settle();
    expect(names()).toEqual(['a 1', 'b 0']);
  });

  it('asks whether a client that became unavailable is away or gone', async () => {
    const gone = ClientState.UNAVAILABLE;
    const { names, announce, store, call } = setup(
      [person('a'), person('b')],
      [person('b', gone)],
      [],
    );
    await settle();
    announce(person('b', gone));
    await settle();
    expect(call).toHaveBeenLastCalledWith('clientGetList', { elements: [{ id: 'b' }] });
    expect(names()).toEqual(['a 0', 'b 2']);
    announce(person('b', gone));
    await settle();
    expect(names()).toEqual(['a 0']);
    expect(store.find('b')?.name, 'its topics keep a name').toBe('b');
  });

  it('asks once for many clients that leave together, for all of them when they are too many', async () => {
    const crowd = Array.from({ length: 21 }, (_, index) => person(`c${index}`));
    const { announce, call } = setup(crowd);
    await settle();
    for (const { id } of crowd.slice(0, 20)) announce(person(id, ClientState.UNAVAILABLE));
    await settle();
    expect(call.mock.calls.at(-1)?.[1]).toMatchObject({ elements: { length: 20 } });
    for (const { id } of crowd) announce(person(id, ClientState.UNAVAILABLE));
    await settle();
    expect(call.mock.calls.slice(1)).toHaveLength(2);
    expect(call.mock.calls.at(-1)).toEqual(['clientGetList']);
  });

  it('an announcement that comes while a list is on its way is newer than the list', async () => {
    const { names, announce, isConnected, call } = setup([person('a')]);
    await settle();
    let answer: (list: unknown) => void = () => undefined;
    call.mockReturnValueOnce(new Promise((resolve) => (answer = resolve)));
    isConnected.value = false;
    await nextTick();
    isConnected.value = true;
    await nextTick();
    announce(person('a', ClientState.INACTIVE));
    answer({ elements: [person('a')] });
    await settle();
    expect(names()).toEqual(['a 1']);
  });

  it('updates round trips only while there are viewers', async () => {
    const { store, call } = setup([person('a')]);
    await settle();
    expect(call).toHaveBeenCalledTimes(1);
    const viewer = effectScope();
    viewer.run(() => store.keepFresh(2000));
    await settle();
    expect(call).toHaveBeenCalledTimes(2);
    await vi.advanceTimersByTimeAsync(2000);
    expect(call).toHaveBeenCalledTimes(3);
    viewer.stop();
    await vi.advanceTimersByTimeAsync(10_000);
    expect(call).toHaveBeenCalledTimes(3);
  });
});

describe('master status store', () => {
  const reply = (nowMs: number) => ({
    masterId: 'm',
    startedMs: 1,
    nowMs,
    samples: [],
    events: [],
  });

  it('asks once a second from where it was [EX-16]', async () => {
    const { client, call } = fakeClient();
    call.mockResolvedValueOnce(reply(5000)).mockResolvedValue(reply(6000));
    const store = scope.run(() => createMasterStatusStore(client, ref(true), () => 0))!;
    await settle();
    expect(store.view.value?.latest.nowMs).toBe(5000);
    await vi.advanceTimersByTimeAsync(1000);
    expect(call.mock.calls).toEqual([
      ['masterStatus', { sinceMs: 0 }],
      ['masterStatus', { sinceMs: 4999 }],
    ]);
  });

  it('keeps what it knows when the link fails, and knows an original master by its answer', async () => {
    const { client, call } = fakeClient();
    call
      .mockResolvedValueOnce(reply(5000))
      .mockRejectedValueOnce(new ConnectionError('closed', 'Gone.'))
      .mockRejectedValueOnce(new ServiceError('unimplemented', 'No such service.'));
    const store = scope.run(() => createMasterStatusStore(client, ref(true), () => 0))!;
    await settle();
    await vi.advanceTimersByTimeAsync(1000);
    expect(store.view.value?.latest.nowMs).toBe(5000);
    expect(store.isUnsupported.value).toBe(false);
    await vi.advanceTimersByTimeAsync(1000);
    expect(store.isUnsupported.value).toBe(true);
  });
});

describe('topic statistics store', () => {
  it('requests nothing without viewers, then continues from the last cursor', async () => {
    const { client, call } = fakeClient();
    call.mockImplementation(async (_service, request) => {
      const { cursor } = request as { cursor: number };
      return {
        cursor: cursor + 7,
        reset: cursor === 0,
        elements: [],
        removed: [],
        masterTimeMs: 1,
      };
    });
    const store = scope.run(() => createTopicStatisticsStore(client, ref(true), () => 0))!;
    await vi.advanceTimersByTimeAsync(5000);
    expect(call).not.toHaveBeenCalled();
    expect(store.rates.value).toBeUndefined();
    scope.run(() => store.watch(250));
    await settle();
    await vi.advanceTimersByTimeAsync(250);
    expect(call.mock.calls).toEqual([
      ['topicStatistics', { cursor: 0 }],
      ['topicStatistics', { cursor: 7 }],
    ]);
    expect(store.rates.value?.size).toBe(0);
    await flushPromises();
  });

  it('knows no rates while the master is away, and tells views so', async () => {
    const { client, call } = fakeClient();
    const counted = { topic: '/a', dataFormat: 'double', publishedMs: 1, bytes: 0, dropped: 0 };
    let replies = 0;
    call.mockImplementation(async () => ({
      cursor: ++replies,
      reset: replies === 1,
      elements: [{ ...counted, records: replies * 10 }],
      removed: [],
      masterTimeMs: replies * 1000,
    }));
    const isConnected = ref(true);
    const store = scope.run(() => createTopicStatisticsStore(client, isConnected, () => 0))!;
    scope.run(() => store.watch(250));
    await settle();
    await vi.advanceTimersByTimeAsync(250);
    expect(store.rates.value?.get('/a')?.hz).toBe(10);
    const seen = vi.fn();
    scope.run(() => watch(store.rates, (rates) => seen(rates?.get('/a')?.hz)));
    isConnected.value = false;
    await nextTick();
    await nextTick();
    expect(seen).toHaveBeenLastCalledWith(undefined);
    expect(store.rates.value?.has('/a')).toBe(true);
  });
});

describe('nodes store', () => {
  it('requests nodes while there are viewers, and keeps the names of nodes that left [PM-61]', async () => {
    const call = vi.fn<(service: string) => Promise<unknown>>();
    call.mockResolvedValueOnce({ elements: [{ clientId: 'n', name: 'Lab' }] });
    call.mockResolvedValue({ elements: [] });
    const store = scope.run(() => createNodesStore({ call } as unknown as UbiiClient, ref(true)))!;
    await settle();
    expect(call).not.toHaveBeenCalled();
    const viewer = effectScope();
    viewer.run(() => store.watch(1000));
    await settle();
    expect(store.list.value).toHaveLength(1);
    await vi.advanceTimersByTimeAsync(1000);
    expect(store.list.value).toEqual([]);
    expect(store.find('n')?.name).toBe('Lab');
    viewer.stop();
  });
});
