// @vitest-environment happy-dom
import { disableAutoUnmount, enableAutoUnmount, flushPromises, mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { computed, defineComponent, nextTick, ref, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { fakeTopics } from '../../connection/live/testing/fake-topics.ts';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { graphOf } from '../model/graph-of.ts';
import { aModule, aSessionOf } from '../model/testing/small-graph.ts';
import { useLiveGraph, type LiveGraph } from './live-graph.ts';

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame', 'performance'] });
});
afterEach(() => {
  vi.useRealTimers();
});
// Another file of this worker may have enabled it.
disableAutoUnmount();
enableAutoUnmount(afterEach);

/** Statistics of a topic that was subscribed and never published. */
const SUBSCRIBED: TopicRate = {
  statistic: {
    topic: '/first',
    dataFormat: '',
    publisherId: '',
    records: 0,
    bytes: 0,
    dropped: 0,
    publishedMs: 0,
    subscribers: 1,
    valueBytes: 0,
  },
  hz: 0,
  bytesPerSecond: 0,
  droppedPerSecond: 0,
  usualHz: undefined,
};

/** Mounts a graph whose module writes to /first. */
function mountGraph(rates = new Map<string, TopicRate>()) {
  const { client, publish } = fakeTopics();
  const connection = {
    client,
    isConnected: ref(true),
    master: { view: shallowRef() },
    masterId: shallowRef(''),
    clients: { list: shallowRef([]), find: () => undefined },
    topics: {
      rates: shallowRef(rates),
      masterTimeMs: shallowRef(0),
      watch: () => undefined,
      onChanges: () => undefined,
    },
  };
  const session = aSessionOf([aModule('a', {}, { out: 'double' })], { 'a.out': '/first' });
  let live: LiveGraph | undefined;
  const wrapper = mount(
    defineComponent(() => {
      live = useLiveGraph(
        shallowRef(session),
        computed(() => graphOf(session)),
      );
      return () => {
        const topic = live?.topic('/first');
        return topic === undefined ? 'nothing known' : (topic.text ?? 'no value');
      };
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  const draw = async (): Promise<string> => {
    await flushPromises();
    vi.advanceTimersByTime(500);
    await nextTick();
    return wrapper.text();
  };
  return { publish, draw, pause: (isPaused: boolean) => (live!.isPaused.value = isPaused) };
}

it('shows the first value of a topic before the master has counted it', async () => {
  const { publish, draw } = mountGraph();
  publish('/first', 3);
  expect(await draw()).toBe('3.00');
});

it('shows no rate of a topic that has counters only because the graph subscribed to it', async () => {
  const { publish, draw } = mountGraph(new Map([['/first', SUBSCRIBED]]));
  expect(await draw()).toBe('nothing known');
  publish('/first', 3);
  expect(await draw()).toBe('3.00');
});

it('keeps the shown values while it is paused, then shows the newest', async () => {
  const { publish, draw, pause } = mountGraph();
  publish('/first', 3);
  expect(await draw()).toBe('3.00');
  pause(true);
  publish('/first', 4);
  expect(await draw()).toBe('3.00');
  pause(false);
  expect(await draw()).toBe('4.00');
});
