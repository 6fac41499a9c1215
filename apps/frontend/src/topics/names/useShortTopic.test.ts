// @vitest-environment happy-dom
import { ClientState, type Client } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { defineComponent, shallowRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import { useShortTopic, type ShortTopic } from './useShortTopic.ts';

const ID = '9b2f9c1e-3f0a-4d6e-8a11-0c1d2e3f4a5b';

/** Returns the display form of a topic when the client is present. */
function shortened(client: Client | undefined, topic: string): ShortTopic {
  const clients = {
    list: shallowRef(client ? [client] : []),
    find: (id: string) => (client?.id === id ? client : undefined),
  };
  const master = { view: shallowRef() };
  const masterId = shallowRef('');
  const connection = { clients, master, masterId } as unknown as Connection;
  let short!: ShortTopic;
  mount(
    defineComponent(() => {
      short = useShortTopic()(topic);
      return () => undefined;
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  return short;
}

it('the name of a client stands for its id in topics', () => {
  const robot = { id: ID, name: 'Robot', state: ClientState.ACTIVE } as Client;
  expect(shortened(robot, `/${ID}/a/b`)).toEqual({ text: '/a/b', owner: 'Robot' });
  expect(shortened(undefined, `/${ID}/a/b`)).toEqual({ text: '/a/b', owner: 'Client 9b2f9c1e' });
  expect(shortened(robot, '/lab/light')).toEqual({ text: '/lab/light', owner: undefined });
});
