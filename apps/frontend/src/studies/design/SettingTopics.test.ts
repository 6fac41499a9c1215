// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { expect, it } from 'vitest';
import { nextTick } from 'vue';
import SettingTopics from './SettingTopics.vue';

it('topics with settings are patterns that are separated by spaces or commas', async () => {
  const field = mount(SettingTopics, { props: { modelValue: ['/room/**'] } });
  const input = field.get('input');
  expect(input.element.value).toBe('/room/**');
  await input.setValue('/room/**, /lab/light ');
  expect(field.emitted('update:modelValue')).toEqual([[['/room/**', '/lab/light']]]);
  // The study that is saved has the patterns, and the text stays as it was typed.
  await field.setProps({ modelValue: ['/room/**', '/lab/light'] });
  expect(input.element.value).toBe('/room/**, /lab/light ');
  await field.setProps({ modelValue: [] });
  await nextTick();
  expect(input.element.value).toBe('');
});
