// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, nextTick } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { useRail, type Rail } from './useRail.ts';

const page = { render: () => null };

async function open(path: string, screenPx = 1440) {
  vi.stubGlobal('matchMedia', (query: string) => ({
    matches: screenPx >= Number(/min-width: (\d+)px/.exec(query)?.[1]),
    addEventListener: () => undefined,
    removeEventListener: () => undefined,
  }));
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/:path(.*)*', component: page }],
  });
  await router.push(path);
  let rail!: Rail;
  const wrapper = mount(
    defineComponent({
      setup() {
        rail = useRail();
        return () => null;
      },
    }),
    { global: { plugins: [router] } },
  );
  return { rail, router, wrapper };
}

beforeEach(() => localStorage.clear());
afterEach(() => void vi.unstubAllGlobals());

describe('useRail', () => {
  it('shows labels on wide screens, and remembers when they are hidden', async () => {
    const first = await open('/topics');
    expect(first.rail.isWide.value).toBe(true);
    first.rail.toggle();
    expect(first.rail.isWide.value).toBe(false);
    await nextTick();
    first.wrapper.unmount();
    expect((await open('/')).rail.isWide.value).toBe(false);
  });

  it('starts narrow in editors, which remember their own choice', async () => {
    const { rail, router } = await open('/sessions/abc/graph');
    expect(rail.isWide.value).toBe(false);
    rail.toggle();
    expect(rail.isWide.value).toBe(true);
    await router.push('/modules/clock');
    expect(rail.isWide.value).toBe(true);
    rail.toggle();
    await router.push('/modules');
    expect(rail.isWide.value).toBe(true);
  });

  it('has no labels where they would take the room of the page', async () => {
    const { rail } = await open('/', 1024);
    expect(rail.canBeWide.value).toBe(false);
    expect(rail.isWide.value).toBe(false);
  });
});
