// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { NO_SPARK } from '../../../topics/rows/sparkline.ts';
import type { LiveTopic } from '../../live/live-topic.ts';
import TopicNow from './TopicNow.vue';

const UNPUBLISHED: LiveTopic = {
  hz: undefined,
  text: undefined,
  record: undefined,
  spark: NO_SPARK,
  ageMs: undefined,
  isStale: false,
  droppedPerSecond: 0,
  format: '',
  publisherId: '',
};
const textOf = (topic: LiveTopic | undefined): string =>
  mount(TopicNow, { props: { read: () => topic, family: 'number' } })
    .get('.value')
    .text();

describe('TopicNow', () => {
  it('shows the same text for a topic without records, subscribed or not', () => {
    expect(textOf(undefined)).toBe('nothing published');
    expect(textOf(UNPUBLISHED)).toBe('nothing published');
  });

  it('shows "no value" for a published record without a value', () => {
    expect(textOf({ ...UNPUBLISHED, ageMs: 20 })).toBe('no value');
  });

  it('shows the value of a published record', () => {
    expect(textOf({ ...UNPUBLISHED, ageMs: 20, text: '0.5' })).toBe('0.5');
  });

  it('shows a colour as what it looks like', () => {
    const value = { r: 1, g: 0.5, b: 0, a: 1 };
    const topic = { ...UNPUBLISHED, ageMs: 20, text: '1, 0.5, 0, 1' };
    const record = { topic: '/c', format: 'color', value } as LiveTopic['record'];
    const shown = mount(TopicNow, {
      props: { read: () => ({ ...topic, record }), family: 'vector' },
    });
    expect(shown.find('.swatch').exists()).toBe(true);
  });
});
