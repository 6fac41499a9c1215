// @vitest-environment happy-dom
import { messageDescriptor, toJson } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import MessageInput from './MessageInput.vue';

const show = (
  name: 'ubii.devices.Device' | 'ubii.dataStructure.Image2D',
  json = toJson(name, {}),
) => mount(MessageInput, { props: { type: messageDescriptor(name), json, path: 'x', label: 'x' } });

describe('MessageInput', () => {
  it('leaves the fields of empty texts empty', () => {
    const inputs = show('ubii.devices.Device').findAll<HTMLInputElement>('input[type="text"]');
    expect(inputs.map(({ element }) => element.value)).toEqual(['', '', '', '']);
  });

  it('counts no bytes where there are none', () => {
    expect(show('ubii.dataStructure.Image2D').get('[role="group"]').text()).toContain('0 B');
  });
});
