// @vitest-environment happy-dom
import { messageDescriptor, toJson } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import MessageField from './MessageField.vue';

const show = (
  name: 'ubii.devices.Device' | 'ubii.dataStructure.Image2D',
  json = toJson(name, {}),
) => {
  const type = messageDescriptor(name);
  const field = {
    number: 1,
    protoName: 'x',
    jsonName: 'x',
    type,
    repeated: false,
    oneof: undefined,
  };
  return mount(MessageField, { props: { field, json, path: 'x' } });
};

describe('MessageField', () => {
  it('leaves the fields of empty texts empty', () => {
    const inputs = show('ubii.devices.Device').findAll<HTMLInputElement>('input[type="text"]');
    expect(inputs.map(({ element }) => element.value)).toEqual(['', '', '', '']);
  });

  it('emits the whole message when a member of a list element changes', async () => {
    const device = { name: 'pad', components: [{ topic: '/old' }, { topic: '/other' }] };
    const form = show('ubii.devices.Device', device);
    const topic = form
      .findAll<HTMLInputElement>('input')
      .find(({ element }) => element.value === '/old')!;
    await topic.setValue('/new');
    expect(form.emitted('change')).toEqual([
      [{ name: 'pad', components: [{ topic: '/new' }, { topic: '/other' }] }],
    ]);
  });

  it('counts no bytes where there are none', () => {
    expect(show('ubii.dataStructure.Image2D').get('[role="group"]').text()).toContain('0 B');
  });
});
