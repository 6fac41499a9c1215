// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { defineComponent } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { useRail } from './useRail.ts';

const page = { render: () => null };

async function open(path: string, screenPx = 1440) {
  vi.stubGlobal('matchMedia', (query: string) => ({
    matches: screenPx >= Number(/min-width: (\d+)px/.exec(query)?.[1]),
    addEventListener: () => undefined,
    removeEventListener: () => undefined,
  }));
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [
      { path: '/', component: page },
      { path: '/topics', component: page },
      { path: '/graph', component: page, meta: { title: 'Graph', isFullBleed: true } },
    ],
  });
  await router.push(path);
  let rail!: ReturnType<typeof useRail>;
  mount(
    defineComponent({
      setup() {
        rail = useRail();
        return () => null;
      },
    }),
    { global: { plugins: [router] } },
  );
  return { rail, router };
}

afterEach(() => void vi.unstubAllGlobals());

describe('useRail', () => {
  it('shows labels on wide screens, and not beside pages from edge to edge', async () => {
    const { rail, router } = await open('/topics');
    expect(rail.isWide.value).toBe(true);
    await router.push('/graph');
    expect(rail.isWide.value).toBe(false);
    await router.push('/topics');
    expect(rail.isWide.value).toBe(true);
  });

  it('has no labels where they would take the room of the page', async () => {
    const { rail } = await open('/', 1024);
    expect(rail.isWide.value).toBe(false);
  });
});
