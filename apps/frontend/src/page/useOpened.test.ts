// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, nextTick, shallowRef } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { useOpened, type Opened } from './useOpened.ts';

const page = { render: () => null };

async function open(path: string, isPhone = false, isThere?: (id: string) => boolean) {
  vi.stubGlobal('matchMedia', () => ({
    matches: isPhone,
    addEventListener: () => undefined,
    removeEventListener: () => undefined,
  }));
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/modules/:name?', component: page }],
  });
  await router.push(path);
  const ids = shallowRef(['adder', 'clock', 'mix']);
  let opened!: Opened;
  mount(
    defineComponent({
      setup() {
        opened = useOpened('name', () => ids.value, isThere);
        return () => null;
      },
    }),
    { global: { plugins: [router] } },
  );
  return { ids, opened, router };
}

afterEach(() => void vi.unstubAllGlobals());

describe('useOpened', () => {
  it('opens the first of the list where the address names none', async () => {
    const { opened } = await open('/modules');
    expect(opened.named.value).toBeUndefined();
    expect(opened.shown.value).toBe('adder');
  });

  it('opens what the address names', async () => {
    const { opened } = await open('/modules/clock');
    expect(opened.shown.value).toBe('clock');
  });

  it('keeps what a tree still has when its row is folded away', async () => {
    const { ids, opened } = await open('/modules', false, (id) => id !== 'clock');
    ids.value = ['clock'];
    await nextTick();
    expect(opened.shown.value).toBe('adder');
  });

  it('opens nothing by itself on a phone', async () => {
    const { opened } = await open('/modules', true);
    expect(opened.shown.value).toBeUndefined();
  });

  it('keeps what is opened when the order of the list changes', async () => {
    const { ids, opened } = await open('/modules');
    ids.value = ['mix', 'clock', 'adder'];
    await nextTick();
    expect(opened.shown.value).toBe('adder');
  });

  it('opens the next first when the list lost what was opened', async () => {
    const { ids, opened } = await open('/modules');
    ids.value = ['clock', 'mix'];
    await nextTick();
    expect(opened.shown.value).toBe('clock');
  });
});
