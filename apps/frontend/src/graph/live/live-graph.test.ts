// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { computed, defineComponent, nextTick, ref, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { fakeTopics } from '../../connection/live/testing/fake-topics.ts';
import { graphOf } from '../model/graph-of.ts';
import { aModule, aSessionOf } from '../model/testing/small-graph.ts';
import { useLiveGraph } from './live-graph.ts';

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame', 'performance'] });
});
afterEach(() => {
  vi.useRealTimers();
});

it('shows the first value of a topic before the master has counted it', async () => {
  const { client, publish } = fakeTopics();
  const connection = {
    client,
    isConnected: ref(true),
    masterId: shallowRef(''),
    clients: { list: shallowRef([]), find: () => undefined },
    topics: {
      rates: shallowRef(),
      masterTimeMs: shallowRef(0),
      watch: () => undefined,
      onChanges: () => undefined,
    },
  };
  const session = aSessionOf([aModule('a', {}, { out: 'double' })], { 'a.out': '/first' });
  const wrapper = mount(
    defineComponent(() => {
      const live = useLiveGraph(
        shallowRef(session),
        computed(() => graphOf(session)),
      );
      return () => live.topic('/first')?.text ?? 'no value';
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  publish('/first', 3);
  await flushPromises();
  vi.advanceTimersByTime(500);
  await nextTick();
  expect(wrapper.text()).toBe('3.00');
});
