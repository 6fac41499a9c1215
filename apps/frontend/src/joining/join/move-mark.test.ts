// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { createMemoryHistory, createRouter } from 'vue-router';
import { replaceWithMark } from './move-mark.ts';

const page = { render: () => undefined };
const loaded = vi.fn(() => Promise.resolve(page));
const router = () =>
  createRouter({
    history: createMemoryHistory(),
    routes: [
      { path: '/join', component: page },
      { path: '/device', component: loaded },
    ],
  });

function browser(isStill: boolean, transition?: (update: () => Promise<unknown>) => object): void {
  vi.stubGlobal('matchMedia', () => ({ matches: isStill }));
  Object.assign(document, { startViewTransition: transition });
}
afterEach(() => vi.unstubAllGlobals());

describe('the page after joining', () => {
  it('is loaded before the mark moves to it', async () => {
    const transition = vi.fn((update: () => Promise<unknown>) => {
      expect(loaded).toHaveBeenCalled();
      return { updateCallbackDone: update() };
    });
    browser(false, transition);
    const own = router();
    await replaceWithMark(own, '/device');
    expect(transition).toHaveBeenCalledOnce();
    expect(own.currentRoute.value.path).toBe('/device');
  });

  it('comes at once for people who want less motion, and in browsers without transitions', async () => {
    const transition = vi.fn();
    browser(true, transition as never);
    const own = router();
    await replaceWithMark(own, '/device');
    expect(own.currentRoute.value.path).toBe('/device');
    browser(false);
    await replaceWithMark(own, '/join');
    expect(own.currentRoute.value.path).toBe('/join');
    expect(transition).not.toHaveBeenCalled();
  });
});
