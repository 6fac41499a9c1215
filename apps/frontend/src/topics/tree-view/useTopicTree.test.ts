// @vitest-environment happy-dom
import { disableAutoUnmount, enableAutoUnmount, mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick, ref, shallowRef, triggerRef } from 'vue';
import { CONNECTION, type Connection } from '../../connection/connection.ts';
import { fakeTopics } from '../../connection/live/testing/fake-topics.ts';
import type { TopicChanges, TopicRate } from '../../connection/topic-rates.ts';
import type { TopicOrder } from '../tree/topic-order.ts';
import { useTopicTree, type TopicTreeView } from './useTopicTree.ts';

const rateOf = (topic: string): TopicRate => ({
  statistic: {
    topic,
    dataFormat: 'double',
    publisherId: '',
    records: 1,
    bytes: 0,
    dropped: 0,
    publishedMs: 0,
    subscribers: 0,
    valueBytes: 8,
  },
  hz: 1,
  bytesPerSecond: 8,
  droppedPerSecond: 0,
  usualHz: 1,
});

/** Mounts a tree on a connection whose statistics the test provides. */
function setUp(first: readonly TopicRate[] = []) {
  const rates = shallowRef(new Map(first.map((rate) => [rate.statistic.topic, rate])));
  const isConnected = ref(true);
  const listeners = new Set<(changes: TopicChanges) => void>();
  const asked: number[] = [];
  const live = fakeTopics();
  const connection = {
    client: live.client,
    isConnected,
    clients: { list: shallowRef([]), find: () => undefined },
    master: { view: shallowRef() },
    masterId: shallowRef(''),
    topics: {
      rates,
      masterTimeMs: shallowRef(0),
      watch: (intervalMs: number) => asked.push(intervalMs),
      onChanges: (fn: (changes: TopicChanges) => void) => listeners.add(fn),
    },
  } as unknown as Connection;

  const search = ref('');
  const format = ref('');
  const order = ref<TopicOrder>('name');
  const isPaused = ref(false);
  let view!: TopicTreeView;
  const wrapper = mount(
    defineComponent(() => {
      view = useTopicTree({ search, format, order, isPaused });
      return () => h('div');
    }),
    { global: { provide: { [CONNECTION as symbol]: connection } } },
  );
  const reply = (changes: Partial<TopicChanges>) => {
    for (const rate of changes.removed ?? []) rates.value.delete(rate.statistic.topic);
    for (const rate of changes.added ?? []) rates.value.set(rate.statistic.topic, rate);
    for (const listener of listeners) listener({ added: [], removed: [], ...changes });
    triggerRef(rates);
  };
  return { view, wrapper, reply, search, isPaused, isConnected, asked, ...live };
}

const keys = (view: TopicTreeView) => view.rows.value.map(({ key }) => key);
const frames = (count: number) => vi.advanceTimersByTime(count * 16);

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame', 'performance'] });
});
afterEach(() => {
  vi.useRealTimers();
});
// Another file of this worker may have enabled it.
disableAutoUnmount();
enableAutoUnmount(afterEach);

describe('useTopicTree', () => {
  it('shows at once what was known before the page was opened', () => {
    expect(keys(setUp([rateOf('/a')]).view)).toEqual(['/a']);
  });

  it('draws new statistics a few times a second, not with every reply', () => {
    const { view, reply } = setUp();
    frames(20);
    const before = view.tick.value;
    for (let i = 0; i < 62; i++) {
      reply({ added: [rateOf(`/${i}`)] });
      frames(1);
    }
    expect(view.tick.value - before).toBeLessThanOrEqual(9);
    frames(10);
    expect(view.rows.value).toHaveLength(62);
  });

  it('draws once that rates are unknown when the master goes away, with every row where it was', () => {
    const { view, reply, isConnected } = setUp([rateOf('/a/b'), rateOf('/a/c')]);
    frames(20);
    expect(view.rows.value[0]).toMatchObject({ key: '/a', hz: 2, isRateKnown: true });
    const before = keys(view);
    isConnected.value = false;
    for (const topic of ['/a/b', '/a/c']) {
      Object.assign(view.model.find(topic)!.rate!, { hz: undefined });
    }
    reply({});
    frames(20);
    expect(view.rows.value[0]).toMatchObject({ key: '/a', isRateKnown: false });
    expect(keys(view)).toEqual(before);
  });

  it('stands still while paused and has lost nothing afterwards', async () => {
    const { view, reply, isPaused, asked } = setUp([rateOf('/a')]);
    expect(asked).toHaveLength(1);
    isPaused.value = true;
    await nextTick();
    const tick = view.tick.value;
    reply({ added: [rateOf('/b')] });
    frames(60);
    expect(keys(view)).toEqual(['/a']);
    expect(view.tick.value).toBe(tick);
    isPaused.value = false;
    await nextTick();
    frames(60);
    expect(keys(view)).toEqual(['/a', '/b']);
    expect(asked).toHaveLength(2);
  });

  it('answers a search also while paused', async () => {
    const { view, search, isPaused } = setUp([rateOf('/a'), rateOf('/b')]);
    isPaused.value = true;
    search.value = 'b';
    await nextTick();
    expect(keys(view)).toEqual(['/b']);
  });

  it('keeps what it shows while disconnected', () => {
    const { view, isConnected } = setUp([rateOf('/a')]);
    isConnected.value = false;
    const tick = view.tick.value;
    frames(60);
    expect(keys(view)).toEqual(['/a']);
    expect(view.tick.value).toBe(tick);
  });

  it('ends its subscriptions with the page', async () => {
    const { view, wrapper, subscriptions } = setUp([rateOf('/a')]);
    view.values.show([rateOf('/a')]);
    await nextTick();
    expect(subscriptions()).toMatchObject([{ pattern: { topic: '/a' } }]);
    wrapper.unmount();
    expect(subscriptions()).toEqual([]);
  });
});
