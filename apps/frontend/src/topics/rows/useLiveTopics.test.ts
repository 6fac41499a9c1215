// @vitest-environment happy-dom
import { disableAutoUnmount, enableAutoUnmount, flushPromises, mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { defineComponent, nextTick, ref, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { fakeTopics } from '../../connection/live/testing/fake-topics.ts';
import { useLiveTopics } from './useLiveTopics.ts';

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame', 'performance'] });
});
afterEach(() => {
  vi.useRealTimers();
});
// Another file of this worker may have enabled it.
disableAutoUnmount();
enableAutoUnmount(afterEach);

it('shows the first value of a topic before the master has counted it', async () => {
  const { client, publish, subscriptions } = fakeTopics();
  const connection = {
    client,
    isConnected: ref(true),
    topics: { rates: shallowRef(), watch: () => undefined },
  };
  const wanted = ref(['/a']);
  const wrapper = mount(
    defineComponent(() => {
      const liveOf = useLiveTopics(() => wanted.value);
      return () => liveOf('/a').text ?? 'no value';
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  publish('/a', 3);
  await flushPromises();
  vi.advanceTimersByTime(300);
  await nextTick();
  expect(wrapper.text()).toBe('3.00');
  wanted.value = [];
  await flushPromises();
  expect(subscriptions()).toEqual([]);
});
