// @vitest-environment happy-dom
import type { TopicRecord } from '@ubii/proto';
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import JsonTree from './JsonTree.vue';

const record = (value: string, topic = '/a'): TopicRecord => ({
  topic,
  format: 'string',
  value,
  timestampMs: undefined,
  clientId: '',
});
const deep = (id: string) => record(JSON.stringify({ a: { b: { c: { id } } } }));

describe('JsonTree', () => {
  it('opens two levels by itself and keeps what a person opens while values change', async () => {
    const wrapper = mount(JsonTree, { props: { record: deep('first') } });
    expect(wrapper.text()).not.toContain('first');
    await wrapper.get('button[aria-label="c"]').trigger('click');
    expect(wrapper.text()).toContain('first');
    await wrapper.setProps({ record: deep('second') });
    expect(wrapper.text()).toContain('second');
    await wrapper.get('button[aria-label="a"]').trigger('click');
    expect(wrapper.findAll('li')).toHaveLength(1);
  });

  it('shows an empty text as that, not as a truth value', () => {
    const wrapper = mount(JsonTree, { props: { record: record('{"name":""}') } });
    expect(wrapper.text()).toContain('""');
    expect(wrapper.text()).not.toContain('true');
  });

  it('begins again with another topic', async () => {
    const wrapper = mount(JsonTree, { props: { record: deep('first') } });
    await wrapper.get('button[aria-label="a"]').trigger('click');
    await wrapper.setProps({ record: { ...deep('second'), topic: '/b' } });
    expect(wrapper.findAll('li').length).toBeGreaterThan(1);
  });
});
