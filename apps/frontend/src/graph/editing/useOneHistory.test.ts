// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { expect, it, vi } from 'vitest';
import { defineComponent, h, useTemplateRef } from 'vue';
import { useOneHistory } from './useOneHistory.ts';

/** Presses Ctrl Z in an element. @returns whether the browser's own undo was kept from running */
function undoIn(element: Element, keys: KeyboardEventInit = {}): boolean {
  const init = { key: 'z', ctrlKey: true, bubbles: true, cancelable: true, ...keys };
  const event = new KeyboardEvent('keydown', init);
  element.dispatchEvent(event);
  return event.defaultPrevented;
}

it('fields of values have the history of the graph, fields of text their own', () => {
  const editor = { undo: vi.fn(), redo: vi.fn() };
  const wrapper = mount(
    defineComponent({
      setup() {
        useOneHistory(useTemplateRef<HTMLElement>('root'), editor);
        return () =>
          h('div', { ref: 'root' }, [
            h('span', { 'data-one-history': '' }, [h('input', { class: 'value' })]),
            h('textarea'),
            h('button'),
          ]);
      },
    }),
    { attachTo: document.body },
  );
  expect(undoIn(wrapper.get('.value').element)).toBe(true);
  expect(editor.undo).toHaveBeenCalledTimes(1);
  expect(undoIn(wrapper.get('.value').element, { shiftKey: true })).toBe(true);
  expect(undoIn(wrapper.get('.value').element, { key: 'y' })).toBe(true);
  expect(editor.redo).toHaveBeenCalledTimes(2);
  expect(undoIn(wrapper.get('textarea').element)).toBe(false);
  expect(undoIn(wrapper.get('.value').element, { ctrlKey: false })).toBe(false);
  undoIn(wrapper.get('button').element);
  // After Enter in a field, the focus is nowhere.
  undoIn(document.body);
  expect(editor.undo).toHaveBeenCalledTimes(3);
  wrapper.unmount();
  undoIn(document.body);
  expect(editor.undo).toHaveBeenCalledTimes(3);
});
