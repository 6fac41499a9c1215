// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import UiNumberField from './UiNumberField.vue';

describe('a number field', () => {
  const field = (props = {}) =>
    mount(UiNumberField, {
      props: { label: 'Rate', modelValue: 30, min: 1, max: 1000, isWhole: true, ...props },
    });

  it.each([
    ['100', 100],
    [' 7 ', 7],
    ['1e3', 1000],
    ['', undefined],
    ['0', undefined],
    ['1001', undefined],
    ['1.5', undefined],
    ['many', undefined],
  ])('reads "%s" as %s', async (text, value) => {
    const wrapper = field();
    await wrapper.get('input').setValue(text);
    const isRefused = value === undefined;
    expect(wrapper.emitted('update:modelValue')).toEqual(isRefused ? undefined : [[value]]);
    expect(wrapper.emitted('refuse')?.length ?? 0).toBe(isRefused ? 1 : 0);
    expect(wrapper.text().includes('Enter a whole number from 1 to')).toBe(isRefused);
  });

  it('takes a whole number between its bounds, and no other', async () => {
    const wrapper = field();
    const input = wrapper.get('input');
    await input.setValue('60');
    await input.setValue('5000');
    expect(wrapper.emitted('update:modelValue')).toEqual([[60]]);
    expect(input.attributes('aria-invalid')).toBe('true');
  });

  it('shows another number than it gives, and stands for one while it is empty', async () => {
    const wrapper = field({
      modelValue: 0.25,
      min: 0,
      max: 100,
      isWhole: false,
      scale: 100,
      empty: 0,
    });
    const input = wrapper.get('input');
    expect(input.element.value).toBe('25');
    await input.setValue('50');
    await input.setValue('');
    expect(wrapper.emitted('update:modelValue')).toEqual([[0.5], [0]]);
    await input.setValue('101');
    expect(wrapper.text()).toContain('Enter a number from 0 to 100.');
    await wrapper.setProps({ max: Infinity });
    await input.setValue('-1');
    expect(wrapper.text()).toContain('Enter a number from 0 on.');
  });

  it('takes back a refused text by Ctrl Z, and leaves none behind', async () => {
    const wrapper = field({ isTransient: true });
    const input = wrapper.get('input');
    await input.setValue('5000');
    await input.trigger('keydown', { key: 'z', ctrlKey: true });
    expect(input.element.value).toBe('30');
    expect(input.attributes('aria-invalid')).toBeUndefined();
    await input.setValue('5000');
    await input.trigger('focusout');
    expect(input.element.value).toBe('30');
  });

  it('keeps a refused text where the page has no history', async () => {
    const wrapper = field();
    await wrapper.get('input').setValue('5000');
    await wrapper.get('input').trigger('focusout');
    expect(wrapper.get('input').element.value).toBe('5000');
  });

  it('shows the number that an undo gives it while a refused text is in it', async () => {
    const wrapper = field();
    await wrapper.get('input').setValue('5000');
    await wrapper.setProps({ modelValue: 20 });
    expect(wrapper.get('input').element.value).toBe('20');
  });
});
