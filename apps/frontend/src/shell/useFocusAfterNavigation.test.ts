// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h } from 'vue';
import { createMemoryHistory, createRouter, RouterLink, RouterView } from 'vue-router';
import { useFocusAfterNavigation } from './useFocusAfterNavigation.ts';

const pageOf = (title: string) => ({ render: () => [h('h1', title), h('input')] });
const Focusing = { render: () => [h('h1', 'Search'), h('input')], mounted: focusInput };
function focusInput(): void {
  document.querySelector('input')?.focus();
}

async function open() {
  const router = createRouter({
    history: createMemoryHistory(),
    routes: [
      { path: '/', component: pageOf('Home') },
      { path: '/topics', component: pageOf('Topics') },
      { path: '/search', component: Focusing },
    ],
  });
  await router.push('/');
  const Shell = defineComponent({
    setup: () => useFocusAfterNavigation('content'),
    render: () => [
      h(RouterLink, { to: '/topics' }, () => 'Topics'),
      h('main', { id: 'content', tabindex: -1 }, h(RouterView)),
    ],
  });
  const wrapper = mount(Shell, { global: { plugins: [router] }, attachTo: document.body });
  const go = async (to: string): Promise<void> => {
    await router.push(to);
    await vi.runAllTimersAsync();
  };
  return { wrapper, go };
}

describe('after navigating', () => {
  let shell: Awaited<ReturnType<typeof open>>;
  beforeEach(async () => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
    shell = await open();
  });
  afterEach(() => {
    shell.wrapper.unmount();
    vi.useRealTimers();
  });

  it('the heading of the page has the focus, not the link', async () => {
    shell.wrapper.get('a').element.focus();
    await shell.go('/topics');
    expect(document.activeElement?.textContent).toBe('Topics');
    expect(document.activeElement?.tagName).toBe('H1');
  });

  it('a page begins at its top, even when the last one was scrolled', async () => {
    const content = shell.wrapper.get('main').element;
    content.scrollTop = 400;
    await shell.go('/topics');
    expect(content.scrollTop).toBe(0);
    content.scrollTop = 400;
    await shell.go('/#part');
    expect(content.scrollTop).toBe(400);
  });

  it('what the page focuses itself keeps it', async () => {
    await shell.go('/search');
    expect(document.activeElement?.tagName).toBe('INPUT');
  });

  it('another query of the same page moves nothing', async () => {
    await shell.go('/topics');
    shell.wrapper.get('input').element.focus();
    await shell.go('/topics?topic=/a');
    expect(document.activeElement?.tagName).toBe('INPUT');
  });

  it('an open dialog keeps it', async () => {
    const dialog = document.createElement('div');
    dialog.setAttribute('role', 'dialog');
    dialog.innerHTML = '<button></button>';
    document.body.append(dialog);
    dialog.querySelector('button')!.focus();
    await shell.go('/topics');
    expect(document.activeElement?.tagName).toBe('BUTTON');
    dialog.remove();
  });
});
