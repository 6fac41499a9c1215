// @vitest-environment happy-dom
import { ClientState, ClusterMasterState, type Client, type ClusterMaster } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { computed, defineComponent, shallowRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import { useFindPublisher } from './useFindPublisher.ts';

const clientOf = (id: string, state: ClientState): Client =>
  ({ id, name: `Name of ${id}`, state }) as Client;

/** Mounts a view of the client `id`, with a list of clients that the test can change. */
function setUp(id = 'id', masters: readonly Partial<ClusterMaster>[] = []) {
  const list = shallowRef<readonly Client[]>();
  const known = new Map<string, Client>();
  const connection = {
    clients: { list, find: (id: string) => known.get(id) },
    master: { view: shallowRef({ latest: { cluster: { masters } } }) },
    masterId: shallowRef('6d617374-6572-4000-8000-000000000000'),
  } as unknown as Connection;
  const wrapper = mount(
    defineComponent(() => {
      const find = useFindPublisher();
      const found = computed(() => find(id));
      return () =>
        found.value
          ? [found.value.name, found.value.master, found.value.isAway ? 'away' : 'here']
              .filter(Boolean)
              .join(', ')
          : 'no client';
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  const announce = async (clients: readonly Client[]) => {
    for (const client of clients) known.set(client.id, client);
    list.value = clients;
    await wrapper.vm.$nextTick();
  };
  return { wrapper, announce };
}

describe('useFindPublisher', () => {
  it('finds a client that is announced after it was asked for', async () => {
    const { wrapper, announce } = setUp();
    expect(wrapper.text()).toBe('no client');
    await announce([clientOf('id', ClientState.ACTIVE)]);
    expect(wrapper.text()).toBe('Name of id, here');
  });

  it('knows the master, which is no client', async () => {
    const { wrapper, announce } = setUp('6d617374-6572-4000-8000-000000000000');
    await announce([]);
    expect(wrapper.text()).toBe('Master, here');
  });

  it('names masters among several, and that of a client [CU-70]', async () => {
    const { SELF, PRESENT, LOST } = ClusterMasterState;
    const masters = [
      { id: 'a', name: 'hall', state: SELF, addresses: [] },
      { id: 'b', name: 'foyer', state: PRESENT, addresses: [] },
      { id: 'c', name: 'attic', state: LOST, addresses: [] },
    ];
    const client = {
      ...clientOf('id', ClientState.ACTIVE),
      extension: { masterId: 'b' } as Client['extension'],
    };
    const ofClient = setUp('id', masters);
    await ofClient.announce([client]);
    expect(ofClient.wrapper.text()).toBe('Name of id, foyer, here');
    expect(setUp('b', masters).wrapper.text()).toBe('foyer, here');
    expect(setUp('c', masters).wrapper.text()).toBe('attic, away');
  });

  it('marks clients that are away, and still names clients that left', async () => {
    const { wrapper, announce } = setUp();
    await announce([clientOf('id', ClientState.INACTIVE)]);
    expect(wrapper.text()).toBe('Name of id, away');
    await announce([clientOf('id', ClientState.ACTIVE)]);
    expect(wrapper.text()).toBe('Name of id, here');
    await announce([]);
    expect(wrapper.text()).toBe('Name of id, away');
  });

  it('names a client that left before the page was opened by the beginning of its id', async () => {
    const { wrapper, announce } = setUp('9b2f9c1e-3f0a-4d6e-8a11-0c1d2e3f4a5b');
    expect(wrapper.text()).toBe('no client');
    await announce([]);
    expect(wrapper.text()).toBe('Client 9b2f9c1e, away');
  });
});
