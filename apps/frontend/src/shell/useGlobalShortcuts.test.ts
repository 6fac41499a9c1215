// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick } from 'vue';
import { createMemoryHistory, createRouter } from 'vue-router';
import { createShell } from '../page/shell.ts';
import { useSingleKeyShortcuts } from '../ui/keys/useSingleKeyShortcuts.ts';
import { useGlobalShortcuts } from './useGlobalShortcuts.ts';

const Page = { render: () => h('p') };

async function setup() {
  const shell = createShell();
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [
      { path: '/graph', component: Page, meta: { title: 'Graph', ownKeys: 'BC' } },
      { path: '/:path(.*)*', component: Page },
    ],
  });
  await router.push('/');
  const push = vi.spyOn(router, 'push');
  const keep = vi.fn();
  const mark = vi.fn();
  const wrapper = mount(
    defineComponent({
      setup() {
        useGlobalShortcuts(shell, { keep, mark });
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
  return { shell, router, push, keep, mark, wrapper, press };
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

  it('open the palette from an editor that uses Ctrl K itself', async () => {
    const element: Element = world.wrapper.element;
    element.addEventListener('keydown', (event) => event.stopPropagation());
    await world.press('k', { ctrlKey: true }, element);
    expect(world.shell.dialog.value).toBe('palette');
  });

  it('keep what the flight recorder holds', async () => {
    await world.press('k');
    expect(world.keep).toHaveBeenCalledOnce();
    await world.press('k', {}, world.wrapper.element);
    expect(world.keep).toHaveBeenCalledOnce();
  });

  it('mark a moment in what is recorded', async () => {
    await world.press('m');
    expect(world.mark).toHaveBeenCalledOnce();
    expect(world.keep).not.toHaveBeenCalled();
  });

  it('leave a letter to the page that uses it itself', async () => {
    await world.router.push('/graph');
    await world.press('c');
    expect(world.shell.dialog.value).toBeUndefined();
    await world.press('?');
    expect(world.shell.dialog.value).toBe('shortcuts');
    world.shell.close();
    await world.router.push('/');
    await world.press('c');
    expect(world.shell.dialog.value).toBe('connect-phone');
  });

  it('leave no second key of a sequence to the page', async () => {
    await world.router.push('/graph');
    const onPage = vi.fn();
    const node = document.createElement('div');
    node.addEventListener('keydown', (event) => onPage(event.key));
    document.body.append(node);
    await world.press('g', {}, node);
    await world.press('b', {}, node);
    expect(world.push).toHaveBeenLastCalledWith('/publish');
    await world.press('b', {}, node);
    expect(onPage.mock.calls.flat()).toEqual(['g', 'b']);
    node.remove();
  });

  it('do nothing while the user types or a dialog of the shell is open', async () => {
    await world.press('?', {}, world.wrapper.element);
    expect(world.shell.dialog.value).toBeUndefined();
    world.shell.open('connect-phone');
    await world.press('?');
    expect(world.shell.dialog.value).toBe('connect-phone');
  });

  it.each([
    ['a list that is open', '<div role="listbox"><div role="option" tabindex="0"></div></div>'],
    ['a menu', '<div role="menu"><div role="menuitem" tabindex="0"></div></div>'],
    ['a dialog', '<div role="dialog"><button></button></div>'],
    ['a closed list with type-ahead', '<button role="combobox"></button>'],
    ['a text editor', '<div contenteditable="true"><span></span></div>'],
  ])('do nothing while %s has the focus', async (_, html) => {
    const host = document.createElement('div');
    host.innerHTML = html;
    document.body.append(host);
    const inner = host.querySelectorAll('*');
    for (const key of ['c', '?', 'g', 'h']) await world.press(key, {}, inner[inner.length - 1]);
    expect(world.shell.dialog.value).toBeUndefined();
    expect(world.push).not.toHaveBeenCalled();
    // The first key of a sequence is not kept until the field is left.
    await world.press('h');
    expect(world.push).not.toHaveBeenCalled();
    host.remove();
  });

  it('do nothing while a list or menu is open that has lost the focus', async () => {
    const list = document.createElement('div');
    list.setAttribute('role', 'listbox');
    list.dataset['state'] = 'open';
    document.body.append(list);
    await world.press('?');
    expect(world.shell.dialog.value).toBeUndefined();
    list.remove();
    await world.press('?');
    expect(world.shell.dialog.value).toBe('shortcuts');
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
