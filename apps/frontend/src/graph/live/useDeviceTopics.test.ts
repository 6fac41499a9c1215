// @vitest-environment happy-dom
import { ComponentIOType, type Client } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { defineComponent, shallowRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import { useDeviceTopics } from './useDeviceTopics.ts';

const { PUBLISHER, SUBSCRIBER } = ComponentIOType;
const client = {
  name: 'Ada',
  devices: [
    {
      components: [
        { topic: '/a/touch', name: '', messageFormat: 'vector2', ioType: PUBLISHER },
        { topic: '/a/vibrate', messageFormat: 'double', ioType: SUBSCRIBER },
        { topic: '', messageFormat: 'double', ioType: PUBLISHER },
      ],
    },
  ],
} as unknown as Client;

it('are those that a device will publish on, until they have a record', async () => {
  const rates = shallowRef<ReadonlyMap<string, unknown>>(new Map());
  const connection = {
    clients: { list: shallowRef([client]) },
    topics: { rates },
  } as unknown as Connection;
  const wrapper = mount(
    defineComponent(() => {
      const topics = useDeviceTopics();
      return () => topics.value.map(({ name, format }) => `${name} ${format}`).join();
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  expect(wrapper.text()).toBe('touch · Ada vector2');
  rates.value = new Map([['/a/touch', { statistic: { publishedMs: 0 } }]]);
  await wrapper.vm.$nextTick();
  expect(wrapper.text(), 'subscribed to, without a record').toBe('touch · Ada vector2');
  rates.value = new Map([['/a/touch', { statistic: { publishedMs: 1 } }]]);
  await wrapper.vm.$nextTick();
  expect(wrapper.text()).toBe('');
});
