// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { expect, it, vi } from 'vitest';
import { defineComponent, h } from 'vue';
import MarkChoice from './MarkChoice.vue';

it('Enter on a shape or a colour submits the form around it', async () => {
  const onSubmit = vi.fn((event: Event) => event.preventDefault());
  const form = mount(
    defineComponent(
      () => () => h('form', { onSubmit }, h(MarkChoice, { modelValue: { shape: 1, colour: 2 } })),
    ),
    { attachTo: document.body },
  );
  for (const name of ['star', 'coral'])
    await form.get(`[aria-label="${name}"]`).trigger('keydown', { key: 'Enter' });
  expect(onSubmit).toHaveBeenCalledTimes(2);
  form.unmount();
});
