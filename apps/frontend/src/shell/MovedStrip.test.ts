// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { expect, it, vi } from 'vitest';
import { nextTick, shallowRef } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { CONNECTION } from '../connection/connection.ts';
import MovedStrip from './MovedStrip.vue';

async function setup() {
  const isConnected = shallowRef(true);
  const client = { masterUrl: location.origin };
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/topics', component: { render: () => null } }],
  });
  await router.push('/topics?x=1');
  const wrapper = mount(MovedStrip, {
    global: { plugins: [router], provide: { [CONNECTION as symbol]: { client, isConnected } } },
  });
  const move = async (url: string): Promise<void> => {
    isConnected.value = false;
    await nextTick();
    client.masterUrl = url;
    isConnected.value = true;
    await nextTick();
  };
  return { wrapper, move };
}

it('[CU-92] says where the page went on, until it is dismissed, for each place once', async () => {
  const { wrapper, move } = await setup();
  await move(location.origin);
  expect(wrapper.text()).toBe('');
  await move('http://10.0.0.6:8080');
  expect(wrapper.text()).toContain('The master was lost. This page moved to 10.0.0.6:8080.');
  await wrapper.get('[aria-label="Dismiss the message"]').trigger('click');
  expect(wrapper.text()).toBe('');
  await move('http://10.0.0.6:8080');
  expect(wrapper.text()).toBe('');
  await move('https://m3.example');
  expect(wrapper.text()).toContain('m3.example');
});

it('[CU-97] opens the page there, as the same client', async () => {
  const { wrapper, move } = await setup();
  sessionStorage.setItem('ubii.identity', '{"clientId":"ada"}');
  await move('http://10.0.0.6:8080');
  const assign = vi.spyOn(location, 'assign').mockImplementation(() => undefined);
  await wrapper.get('button:not([aria-label])').trigger('click');
  expect(assign.mock.calls[0]?.[0]).toMatch(/^http:\/\/10\.0\.0\.6:8080\/topics\?x=1#moved=.*ada/);
});
