// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import UiSplitter from './UiSplitter.vue';

const setUp = (props: { axis?: 'x' | 'y'; grows?: 'forwards' | 'backwards' }) => {
  const wrapper = mount(UiSplitter, {
    props: { label: 'Width', min: 100, max: 300, usual: 200, modelValue: 200, ...props },
  });
  const sizes = () => wrapper.emitted('update:modelValue')?.map(([size]) => size);
  const { element } = wrapper;
  element.setPointerCapture = () => undefined;
  const drag = async (from: object, to: object) => {
    await wrapper.trigger('pointerdown', from);
    await wrapper.trigger('pointermove', to);
    await wrapper.trigger('pointerup', to);
  };
  return { wrapper, sizes, drag };
};

describe('a splitter', () => {
  it('resizes the pane before it', async () => {
    const { wrapper, sizes, drag } = setUp({});
    await drag({ clientX: 10 }, { clientX: 40 });
    await wrapper.trigger('keydown', { key: 'ArrowLeft' });
    expect(sizes()).toEqual([230, 214]);
  });

  it('resizes the pane after it the other way', async () => {
    const { wrapper, sizes, drag } = setUp({ axis: 'y', grows: 'backwards' });
    await drag({ clientY: 10 }, { clientY: 40 });
    await wrapper.trigger('keydown', { key: 'ArrowUp' });
    await wrapper.trigger('keydown', { key: 'ArrowLeft' });
    expect(sizes()).toEqual([170, 186]);
  });

  it('stays within its limits, and resets on a double-click', async () => {
    const { wrapper, sizes, drag } = setUp({});
    await drag({ clientX: 0 }, { clientX: 1000 });
    await wrapper.trigger('dblclick');
    expect(sizes()).toEqual([300, 200]);
  });
});
