// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import NumberField from './NumberField.vue';

const field = () =>
  mount(NumberField, { props: { id: 'hz', value: 30, unit: 'Hz', min: 1, max: 240 } });

it('takes a whole number between its bounds, and no other', async () => {
  const wrapper = field();
  const input = wrapper.get('input');
  await input.setValue('60');
  await input.setValue('500');
  expect(wrapper.emitted('change')).toEqual([[60]]);
  expect(input.attributes('aria-invalid')).toBe('true');
});

it('takes back a refused text by Ctrl Z, and leaves none behind', async () => {
  const wrapper = field();
  const input = wrapper.get('input');
  await input.setValue('500');
  await input.trigger('keydown', { key: 'z', ctrlKey: true });
  expect(input.element.value).toBe('30');
  expect(input.attributes('aria-invalid')).toBeUndefined();
  await input.setValue('500');
  await input.trigger('focusout');
  expect(input.element.value).toBe('30');
});

it('shows the number that an undo gives it while a refused text is in it', async () => {
  const wrapper = field();
  await wrapper.get('input').setValue('500');
  await wrapper.setProps({ value: 20 });
  expect(wrapper.get('input').element.value).toBe('20');
});
