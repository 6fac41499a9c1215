// @vitest-environment happy-dom
import type { RecordingSelection } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { nextTick } from 'vue';
import { EVERYTHING } from '../../recordings/record/record-choice.ts';
import RecordChoiceFields from '../../recordings/record/RecordChoiceFields.vue';
import RecordedPart from './RecordedPart.vue';

function show() {
  const wrapper = mount(RecordedPart, {
    props: {
      modelValue: undefined,
      'onUpdate:modelValue': (modelValue: RecordingSelection | undefined) =>
        wrapper.setProps({ modelValue }),
    },
    global: { stubs: { RecordChoiceFields: true } },
  });
  const fields = wrapper.findComponent(RecordChoiceFields);
  const choose = async (changes: object): Promise<void> => {
    fields.vm.$emit('update:modelValue', { ...EVERYTHING, ...changes });
    await nextTick();
    await nextTick();
  };
  return { wrapper, fields, choose };
}

it('a kind of which nothing is chosen yet leaves the selection, and says so', async () => {
  const { wrapper, fields, choose } = show();
  await choose({ by: 'topics' });
  expect(wrapper.emitted('update:modelValue')).toBeUndefined();
  expect(wrapper.text()).toContain('Choose what to record.');
  expect(fields.props('modelValue')).toMatchObject({ by: 'topics' });
  await choose({ by: 'topics', patterns: '/a/** ' });
  expect(wrapper.props('modelValue')).toMatchObject({ patterns: ['/a/**'], topics: [] });
  // What is typed stays as it is typed.
  expect(fields.props('modelValue')).toMatchObject({ patterns: '/a/** ' });
});

it('a selection that is undone is shown again', async () => {
  const { wrapper, fields, choose } = show();
  await choose({ by: 'clients', clients: ['Mara'] });
  await wrapper.setProps({ modelValue: undefined });
  expect(fields.props('modelValue')).toEqual(EVERYTHING);
});
