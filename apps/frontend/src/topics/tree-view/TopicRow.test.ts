// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import type { TopicRate } from '../../connection/topic-rates.ts';
import { TopicsModel } from '../tree/topics-model.ts';
import TopicRow from './TopicRow.vue';

const NOW = 1_000_000;
const rateOf = (topic: string, dataFormat = 'vector2'): TopicRate => ({
  statistic: {
    topic,
    dataFormat,
    publisherId: 'id-1',
    records: 1,
    bytes: 0,
    dropped: 0,
    publishedMs: NOW - 38_000,
    subscribers: 0,
    valueBytes: 8,
  },
  hz: 0,
  bytesPerSecond: 0,
  droppedPerSecond: 0,
  usualHz: undefined,
});

function rowOf(topics: readonly TopicRate[], key: string, isAway = false) {
  const findPublisher = (id: string) => (id === 'id-1' ? { name: 'Mara', isAway } : undefined);
  const model = new TopicsModel(findPublisher);
  model.apply({ added: topics, removed: [] });
  model.refresh(0);
  return mount(TopicRow, {
    global: { stubs: { ClientMark: true } },
    props: {
      node: model.find(key)!,
      value: undefined,
      findPublisher,
      nowMs: NOW,
      tick: 1,
      expanded: true,
      active: false,
    },
  });
}

describe('TopicRow', () => {
  const topics = [rateOf('/id-1/a'), rateOf('/id-1/b', 'double')];

  it('names its format for screen readers', () => {
    const row = rowOf(topics, '/id-1/b');
    expect(row.get('[role="img"]').attributes('aria-label')).toBe('double');
  });

  it('names the client and counts its topics', () => {
    const wrapper = rowOf(topics, '/id-1');
    expect(wrapper.get('[role="rowheader"]').text()).toContain('Mara');
    expect(wrapper.get('[role="rowheader"]').text()).toContain('2 topics');
    expect(wrapper.get('[role="rowheader"]').text()).toContain('Live');
  });

  it('says that a client is away and its topics are stale, not by colour alone', () => {
    expect(rowOf(topics, '/id-1', true).get('[role="rowheader"]').text()).toContain('Away');
    expect(rowOf(topics, '/id-1/a', true).get('.age').text()).toContain('stale');
    expect(rowOf(topics, '/id-1/a').get('.age').text()).not.toContain('stale');
  });

  it('says that there is no value', () => {
    const wrapper = rowOf([rateOf('/id-1/a', '')], '/id-1/a');
    expect(wrapper.get('.value').text()).toBe('no value');
  });

  it('toggles by its chevron without being selected', async () => {
    const wrapper = rowOf(topics, '/id-1');
    await wrapper.get('button').trigger('click');
    expect(Object.keys(wrapper.emitted())).toContain('toggle');
    expect(wrapper.emitted('select')).toBeUndefined();
  });
});
