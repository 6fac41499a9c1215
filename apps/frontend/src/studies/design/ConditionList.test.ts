// @vitest-environment happy-dom
import type { StudyCondition } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { nextTick, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import ConditionList from './ConditionList.vue';

function show(...names: readonly string[]) {
  const sessions = { list: shallowRef([{ id: 's1', name: 'Haptics' }]) };
  const wrapper = mount(ConditionList, {
    attachTo: document.body,
    props: {
      modelValue: names.map((name) => ({ name, sessionId: '' })),
      errors: {},
      'onUpdate:modelValue': (modelValue: StudyCondition[]) => wrapper.setProps({ modelValue }),
    },
    global: { provide: { [CONNECTION as symbol]: { sessions } } },
  });
  const order = () => wrapper.props('modelValue').map(({ name }) => name);
  return { wrapper, order };
}

it('arrow keys on a grip move a condition, keep the focus on it and say so', async () => {
  const { wrapper, order } = show('A', 'B', 'C');
  const grips = () => wrapper.findAll('[data-reorder-grip]');
  grips()[0]!.element.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowDown' }));
  await nextTick();
  await nextTick();
  expect(order()).toEqual(['B', 'A', 'C']);
  expect(document.activeElement?.getAttribute('aria-label')).toBe('Move A');
  expect(wrapper.find('[role=status]').text()).toBe('A is now 2 of 3.');
  await grips()[2]!.trigger('keydown', { key: 'ArrowDown' });
  expect(order()).toEqual(['B', 'A', 'C']);
  wrapper.unmount();
});

it('dragging a grip over another row moves the condition there', async () => {
  const { wrapper, order } = show('A', 'B', 'C');
  wrapper.findAll('[data-reorder-row]').forEach(({ element }, index) => {
    element.getBoundingClientRect = () => new DOMRect(0, index * 40, 300, 40);
  });
  const grip = wrapper.findAll('[data-reorder-grip]')[0]!.element;
  grip.dispatchEvent(new PointerEvent('pointerdown', { button: 0 }));
  window.dispatchEvent(new PointerEvent('pointermove', { clientY: 100 }));
  await nextTick();
  expect(order()).toEqual(['B', 'C', 'A']);
  window.dispatchEvent(new PointerEvent('pointerup'));
  window.dispatchEvent(new PointerEvent('pointermove', { clientY: 5 }));
  await nextTick();
  expect(order()).toEqual(['B', 'C', 'A']);
  wrapper.unmount();
});

it('a condition that is added has the focus, and the last one cannot be deleted', async () => {
  const { wrapper, order } = show('A');
  const remove = wrapper.find('[aria-label="Delete A"]');
  await remove.trigger('click');
  expect(order()).toEqual(['A']);
  const add = wrapper.findAll('button').find((one) => one.text() === 'Add condition')!;
  await add.trigger('click');
  await nextTick();
  expect(order()).toEqual(['A', 'Condition 2']);
  expect((document.activeElement as HTMLInputElement).value).toBe('Condition 2');
  await wrapper.find('[aria-label="Delete A"]').trigger('click');
  expect(order()).toEqual(['Condition 2']);
  expect(wrapper.emitted('removed')).toEqual([['A']]);
  wrapper.unmount();
});
