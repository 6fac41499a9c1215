// @vitest-environment happy-dom
import { ServiceError } from '@ubii/proto';
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { shallowRef } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { CONNECTION } from '../../connection/connection.ts';
import NoNetworkHelp from './NoNetworkHelp.vue';
import SimulatedPhone from './SimulatedPhone.vue';

async function open(role: string, call = vi.fn(() => Promise.resolve({}))) {
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/:path(.*)*', component: { render: () => null } }],
  });
  await router.push('/');
  const connection = { client: { call, role }, state: shallowRef({ status: 'connected' }) };
  const wrapper = mount(NoNetworkHelp, {
    global: { plugins: [router], provide: { [CONNECTION as symbol]: connection } },
  });
  const button = (text: string) =>
    wrapper.findAll('button').find((one) => one.text().includes(text));
  return { wrapper, call, button };
}

afterEach(() => void vi.restoreAllMocks());

describe('SimulatedPhone', () => {
  it('opens a phone-sized window without an opener, so that it is a client of its own', async () => {
    const openWindow = vi.spyOn(window, 'open').mockReturnValue(null);
    const wrapper = mount(SimulatedPhone);
    await wrapper.get('button').trigger('click');
    expect(openWindow).toHaveBeenCalledWith(
      '/devices/smart-device',
      '_blank',
      expect.stringMatching(/noopener.*width=390,height=844/),
    );
  });
});

describe('NoNetworkHelp', () => {
  it('an admin on the computer of the master turns on the local network [AC-47]', async () => {
    const { button, call, wrapper } = await open('admin');
    await button('Turn on the local network')!.trigger('click');
    await flushPromises();
    expect(call).toHaveBeenCalledWith('lanOpen');
    expect(button('Turn on the local network')).toBeUndefined();
    // Addresses arrive with the next status; until then, there may be none.
    expect(wrapper.get('[role=status]').text()).toContain('no network address');
  });

  it('shows why the network could not be turned on, and lets the admin try again', async () => {
    const call = vi.fn(() =>
      Promise.reject(new ServiceError('unavailable', 'Port 8080 is taken.')),
    );
    const { button, wrapper } = await open('admin', call);
    await button('Turn on the local network')!.trigger('click');
    await flushPromises();
    expect(wrapper.get('[role=alert]').text()).toBe('Port 8080 is taken.');
    expect(button('Turn on the local network')).toBeDefined();
  });

  it('offers the network to admins only', async () => {
    const { button } = await open('participant');
    expect(button('Turn on the local network')).toBeUndefined();
  });
});
