// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick, ref } from 'vue';
import { CONNECTION } from '../connection.ts';
import { fakeTopics } from './testing/fake-topics.ts';
import { useTopic } from './useTopic.ts';

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame'] });
});
afterEach(() => {
  setVisibility('visible');
  vi.useRealTimers();
});

function setVisibility(visibilityState: DocumentVisibilityState): void {
  Object.defineProperty(document, 'visibilityState', {
    value: visibilityState,
    configurable: true,
  });
  document.dispatchEvent(new Event('visibilitychange'));
}
async function frame(): Promise<void> {
  await flushPromises();
  vi.advanceTimersByTime(16);
  await nextTick();
}

function setUp<T>(use: () => T) {
  const topics = fakeTopics();
  const isConnected = ref(true);
  let used!: T;
  const wrapper = mount(
    defineComponent(() => {
      used = use();
      return () => h('p');
    }),
    { global: { provide: { [CONNECTION as symbol]: { client: topics.client, isConnected } } } },
  );
  return { ...topics, used, wrapper, isConnected };
}
const patterns = ({ subscriptions }: ReturnType<typeof fakeTopics>) =>
  subscriptions().map(({ pattern }) => pattern);

describe('useTopic', () => {
  it('subscribes while the component is mounted', async () => {
    const page = setUp(() => useTopic('/a', { format: 'double', maxRateHz: 5 }));
    expect(page.subscriptions()).toEqual([{ pattern: '/a', format: 'double', maxRateHz: 5 }]);
    page.publish('/a', 1);
    await frame();
    expect(page.used.newest.value?.value).toBe(1);
    expect(page.used.status.value).toBe('live');
    page.wrapper.unmount();
    expect(page.subscriptions()).toEqual([]);
  });

  it('follows its topic, and shows nothing of the one before', async () => {
    const topic = ref<string>();
    const page = setUp(() => useTopic(topic));
    expect(patterns(page)).toEqual([]);
    topic.value = '/a';
    await nextTick();
    page.publish('/a', 1);
    await frame();
    topic.value = '/b';
    await nextTick();
    expect(patterns(page)).toEqual(['/b']);
    expect(page.used.newest.value).toBeUndefined();
  });

  it('rests in a hidden page, and has the newest value when it is seen again', async () => {
    const page = setUp(() => useTopic('/a', { keep: 2 }));
    page.publish('/a', 1, 1000);
    await frame();
    setVisibility('hidden');
    await nextTick();
    expect(patterns(page)).toEqual([]);
    page.publish('/a', 2, 2000);
    setVisibility('visible');
    await nextTick();
    await frame();
    expect(page.used.records.value.map(({ value }) => value)).toEqual([1, 2]);
  });

  it('goes on in a hidden page where each record counts', async () => {
    const heard: unknown[] = [];
    const page = setUp(() =>
      useTopic('/a', { keep: 0, whileHidden: true, onRecord: ({ value }) => heard.push(value) }),
    );
    setVisibility('hidden');
    await nextTick();
    page.publish('/a', 1);
    expect(heard).toEqual([1]);
  });

  it('takes a record once that comes again after a reconnect', async () => {
    const page = setUp(() => useTopic('/a', { keep: 5 }));
    page.publish('/a', 1, 1000);
    page.isConnected.value = false;
    await nextTick();
    page.isConnected.value = true;
    await nextTick();
    page.publish('/a', 1, 1000);
    await frame();
    expect(page.used.counts.value).toMatchObject({ received: 1, dropped: 0 });
    expect(page.used.records.value).toHaveLength(1);
  });

  it('delivers records as they travel', async () => {
    const page = setUp(() => useTopic({ glob: '/a/*' }, { encoded: true }));
    page.publish('/a/b', 1);
    await frame();
    expect(page.used.newest.value?.topic).toBe('/a/b');
    expect(page.used.newest.value?.bytes).toBeInstanceOf(Uint8Array);
    expect([...page.used.byTopic.value.keys()]).toEqual(['/a/b']);
  });
});
