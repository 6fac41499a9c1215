// @vitest-environment happy-dom
import { Scissors } from '@lucide/vue';
import { mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick } from 'vue';
import type { SpanTarget } from '../opened/span-action.ts';
import SpanMenu from './SpanMenu.vue';
import { TIMELINE } from './useTimeline.ts';

const target = { span: { fromMs: 1000, untilMs: 3500 } } as SpanTarget;
const dialog = defineComponent({
  props: { target: { type: Object, required: true } },
  emits: ['close'],
  setup:
    (props, { emit }) =>
    () =>
      h('button', { class: 'dialog', onClick: () => emit('close') }, JSON.stringify(props.target)),
});

const wrappers: { unmount(): void }[] = [];
afterEach(() => wrappers.splice(0).forEach((wrapper) => wrapper.unmount()));

async function openMenu(refusal?: string) {
  const timeline = { show: vi.fn(), setLoop: vi.fn() };
  const actions = [{ text: 'Cut', icon: Scissors, dialog, refusal: () => refusal }];
  const wrapper = mount(SpanMenu, {
    props: { actions, target },
    attachTo: document.body,
    global: { provide: { [TIMELINE as symbol]: timeline } },
  });
  wrappers.push(wrapper);
  await wrapper.find('button').trigger('keydown', { key: 'Enter' });
  await nextTick();
  const items = [...document.querySelectorAll<HTMLElement>('[role=menuitem]')];
  return { timeline, wrapper, items };
}

describe('the menu of a span', () => {
  it('opens the dialog of an action with the span, until it closes', async () => {
    const { wrapper, items } = await openMenu();
    expect(wrapper.find('button').text()).toContain('2.5 s');
    items[0]!.click();
    await nextTick();
    const opened = wrapper.find('.dialog');
    expect(JSON.parse(opened.text())).toEqual(target);
    await opened.trigger('click');
    expect(wrapper.find('.dialog').exists()).toBe(false);
  });

  it('says why an action is not available', async () => {
    const { items } = await openMenu('Upload the file first.');
    expect(items[0]!.textContent).toContain('Upload the file first.');
    expect(items[0]!.hasAttribute('data-disabled')).toBe(true);
  });

  it('clears the span', async () => {
    const { items, timeline } = await openMenu();
    items.at(-1)!.click();
    expect(timeline.setLoop).toHaveBeenCalledWith(undefined);
  });
});
