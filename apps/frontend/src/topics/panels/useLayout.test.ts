// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { h } from 'vue';
import { createMemoryHistory, createRouter, type Router } from 'vue-router';
import { setShare, type LayoutNode } from './layout/layout.ts';
import { useLayout, type LayoutStore } from './useLayout.ts';

const two: LayoutNode = {
  direction: 'row',
  share: 0.5,
  first: { id: '1', viewer: 'plot', topic: '/a', settings: {} },
  second: { id: '2', viewer: 'plot', topic: '/b', settings: {} },
};
const LINK_MS = 250;
let leave: (() => void) | undefined;

/** The page as a browser loads it at this URL. */
async function load(hash: string): Promise<{ store: LayoutStore; router: Router }> {
  leave?.();
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/panels', component: { render: () => h('p') } }],
  });
  await router.push({ path: '/panels', hash });
  let store: LayoutStore | undefined;
  const setup = (): void => void (store = useLayout());
  const wrapper = mount({ setup, render: () => h('p') }, { global: { plugins: [router] } });
  leave = () => wrapper.unmount();
  return { store: store!, router };
}

const shareOf = ({ layout }: LayoutStore): number | undefined => {
  const { root } = layout.value;
  return root && 'share' in root ? root.share : undefined;
};

beforeEach(() => {
  vi.useFakeTimers();
  localStorage.clear();
  sessionStorage.clear();
});
afterEach(() => {
  leave?.();
  leave = undefined;
  vi.useRealTimers();
});

describe('the layout of a tab', () => {
  it.each([0, 1, 2])(
    'is the newest after a reload, also when the browser still says its URL number %i of 3',
    async (reloadedAt) => {
      const { store, router } = await load('');
      const hashes: string[] = [];
      for (const share of [0.5, 0.52, 0.54]) {
        store.change(setShare(two, '', share));
        await vi.advanceTimersByTimeAsync(LINK_MS);
        hashes.push(router.currentRoute.value.hash);
      }
      expect(new Set(hashes)).toHaveLength(3);
      const { store: reloaded } = await load(hashes[reloadedAt]!);
      expect(shareOf(reloaded)).toBe(0.54);
    },
  );

  it('gives way to a link from elsewhere, and is one undo step before it', async () => {
    const first = await load('');
    first.store.change(setShare(two, '', 0.6));
    await vi.advanceTimersByTimeAsync(LINK_MS);
    const link = first.router.currentRoute.value.hash;
    sessionStorage.clear();

    const { store } = await load('');
    store.change(setShare(two, '', 0.7));
    await vi.advanceTimersByTimeAsync(LINK_MS);
    const { store: linked } = await load(link);
    expect(shareOf(linked)).toBe(0.6);
    linked.undo();
    expect(shareOf(linked)).toBe(0.7);
  });
});
