// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, expect, it } from 'vitest';
import { defineComponent, h, nextTick, useTemplateRef } from 'vue';
import { useKeptFocus } from './useKeptFocus.ts';

const Bar = defineComponent({
  props: { names: { type: Array<string>, required: true } },
  setup() {
    useKeptFocus(useTemplateRef<HTMLElement>('host'));
  },
  render() {
    return h(
      'div',
      { ref: 'host' },
      this.names.map((name) => h('button', { key: name }, name)),
    );
  },
});
const mounted = () => {
  const wrapper = mount(Bar, { props: { names: ['pause', 'stop'] }, attachTo: document.body });
  const focus = (name: string): void =>
    wrapper
      .findAll('button')
      .find((one) => one.text() === name)!
      .element.focus();
  return { wrapper, focus };
};
const focused = (): string | null | undefined =>
  document.activeElement === document.body ? undefined : document.activeElement?.textContent;
let current: ReturnType<typeof mounted>['wrapper'];
afterEach(() => current.unmount());

it('gives the focus to the button in place of the one that had it', async () => {
  const { wrapper, focus } = mounted();
  current = wrapper;
  focus('stop');
  await wrapper.setProps({ names: [] });
  expect(focused()).toBeUndefined();
  await wrapper.setProps({ names: ['start'] });
  expect(focused()).toBe('start');
});

it('leaves the focus alone where it went elsewhere', async () => {
  const { wrapper, focus } = mounted();
  current = wrapper;
  const other = document.createElement('input');
  document.body.append(other);
  focus('stop');
  other.focus();
  await wrapper.setProps({ names: ['start'] });
  expect(document.activeElement).toBe(other);
  other.remove();
  await nextTick();
  await wrapper.setProps({ names: ['start', 'more'] });
  expect(focused()).toBeUndefined();
});
