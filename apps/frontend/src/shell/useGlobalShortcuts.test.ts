import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { defineComponent, h, nextTick } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { createShell } from './shell.ts';
import { useGlobalShortcuts, useSingleKeyShortcuts } from './useGlobalShortcuts.ts';

const Page = { render: () => h('p') };

async function setup() {
  const shell = createShell();
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [{ path: '/:path(.*)*', component: Page }],
  });
  await router.push('/');
  const wrapper = mount(
    defineComponent({
      setup() {
        useGlobalShortcuts(shell);
        return { singleKeys: useSingleKeyShortcuts() };
      },
      render: () => h('input'),
    }),
    { global: { plugins: [router] }, attachTo: document.body },
  );
  const press = async (key: string, init: KeyboardEventInit = {}, target?: Element) => {
    (target ?? document.body).dispatchEvent(
      new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true, ...init }),
    );
    await router.isReady();
    await Promise.resolve();
  };
  return { shell, router, wrapper, press };
}

describe('shortcuts', () => {
  let world: Awaited<ReturnType<typeof setup>>;
  beforeEach(async () => {
    localStorage.clear();
    world = await setup();
  });
  afterEach(() => world.wrapper.unmount());

  it('open dialogs, and Ctrl K closes the palette again', async () => {
    await world.press('?');
    expect(world.shell.dialog.value).toBe('shortcuts');
    world.shell.close();
    await world.press('k', { ctrlKey: true });
    expect(world.shell.dialog.value).toBe('palette');
    await world.press('k', { ctrlKey: true });
    expect(world.shell.dialog.value).toBeUndefined();
  });

  it('do nothing while a person types or a dialog is open', async () => {
    await world.press('?', {}, world.wrapper.element);
    expect(world.shell.dialog.value).toBeUndefined();
    world.shell.open('connect-phone');
    await world.press('?');
    expect(world.shell.dialog.value).toBe('connect-phone');
  });

  it('single keys can be switched off, Ctrl K cannot', async () => {
    (world.wrapper.vm as unknown as { singleKeys: boolean }).singleKeys = false;
    await nextTick();
    await nextTick();
    await world.press('?');
    expect(world.shell.dialog.value).toBeUndefined();
    await world.press('k', { metaKey: true });
    expect(world.shell.dialog.value).toBe('palette');
  });
});
