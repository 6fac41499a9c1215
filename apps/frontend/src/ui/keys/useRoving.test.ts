// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { defineComponent, h, nextTick, useTemplateRef } from 'vue';
import { useRoving } from './useRoving.ts';

const List = defineComponent({
  props: { names: { type: Array<string>, required: true } },
  setup() {
    useRoving(useTemplateRef<HTMLElement>('host'), 'button');
  },
  render() {
    const rows = this.names.map((name) => h('button', { key: name }, name));
    return h('div', { ref: 'host' }, [h('input'), ...rows]);
  },
});
let wrapper: ReturnType<typeof mounted>;
const mounted = () => mount(List, { props: { names: ['a', 'b', 'c'] }, attachTo: document.body });
beforeEach(async () => {
  wrapper = mounted();
  await nextTick();
});
afterEach(() => wrapper.unmount());

const stops = (): string[] =>
  wrapper
    .findAll('button')
    .filter(({ element }) => element.tabIndex === 0)
    .map((button) => button.text());
const press = (key: string): boolean =>
  document.activeElement!.dispatchEvent(
    new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }),
  );
const focused = (): string | null | undefined => document.activeElement?.textContent;

it('has one Tab stop, which follows the arrow keys', () => {
  expect(stops()).toEqual(['a']);
  wrapper.get('button').element.focus();
  press('ArrowDown');
  expect(focused()).toBe('b');
  press('End');
  expect(focused()).toBe('c');
  press('ArrowDown');
  expect(focused()).toBe('c');
  expect(stops()).toEqual(['c']);
  press('Home');
  expect(focused()).toBe('a');
});

it('keeps a Tab stop while items come and go', async () => {
  wrapper.get('button').element.focus();
  press('ArrowDown');
  await wrapper.setProps({ names: ['c', 'd', 'b'] });
  await expect.poll(stops).toEqual(['b']);
  await wrapper.setProps({ names: ['d', 'c'] });
  await expect.poll(stops).toEqual(['d']);
});

it('starts at the first item, also when it comes later', async () => {
  await wrapper.setProps({ names: ['z', 'a', 'b'] });
  await expect.poll(stops).toEqual(['z']);
});

it('goes to the item whose text begins with the letters typed', async () => {
  await wrapper.setProps({ names: ['mix', 'low-pass', 'mirror', 'mux'] });
  wrapper.get('button').element.focus();
  expect(press('m')).toBe(false);
  expect(focused()).toBe('mirror');
  press('u');
  expect(focused()).toBe('mux');
  expect(stops()).toEqual(['mux']);
});

it('leaves keys to fields beside the items', () => {
  wrapper.get('input').element.focus();
  expect(press('ArrowDown')).toBe(true);
  expect(press('a')).toBe(true);
  expect(document.activeElement?.tagName).toBe('INPUT');
});
