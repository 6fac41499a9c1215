// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { h } from 'vue';
import { createMemoryHistory, createRouter, RouterView } from 'vue-router';
import ErrorBoundary from './ErrorBoundary.vue';

const page = (text: string) => ({ render: () => h('p', text) });
const broken = {
  setup() {
    throw new Error('matrix is not square');
  },
};

async function open(path: string) {
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [
      { path: '/', component: page('home'), meta: { title: 'Home' } },
      { path: '/broken', component: broken, meta: { title: 'Broken' } },
      {
        path: '/missing',
        component: () => Promise.reject(new Error('Failed to fetch')),
        meta: { title: 'Missing' },
      },
    ],
  });
  await router.push(path);
  const wrapper = mount(ErrorBoundary, {
    slots: { default: () => h(RouterView) },
    global: { plugins: [router] },
  });
  await flushPromises();
  return { router, wrapper };
}

beforeEach(() => {
  vi.stubGlobal('reportError', vi.fn());
  vi.spyOn(console, 'warn').mockImplementation(() => undefined);
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

it('says what stopped and why, and the next page works', async () => {
  const { router, wrapper } = await open('/broken');
  expect(wrapper.get('[role=alert]').text()).toContain('“Broken” stopped');
  expect(wrapper.text()).toContain('matrix is not square');
  expect(reportError).toHaveBeenCalledOnce();
  await router.push('/');
  await flushPromises();
  expect(wrapper.text()).toBe('home');
});

it('a page that cannot be loaded is said, and Home leads back though the address never changed', async () => {
  const { router, wrapper } = await open('/');
  await router.push('/missing').catch(() => undefined);
  await flushPromises();
  expect(wrapper.get('[role=alert]').text()).toContain('“Missing” could not be loaded');
  await wrapper.get('a[href="/"]').trigger('click');
  await flushPromises();
  expect(wrapper.text()).toBe('home');
});
