// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import LiveText from './LiveText.vue';

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

test('screen readers get the newest text, at most every two seconds', async () => {
  const live = mount(LiveText, { props: { text: 'Lap 1 of 3' } });
  const spoken = () => live.get('[role=status]').text();
  await live.setProps({ text: 'Lap 2 of 3' });
  await vi.advanceTimersByTimeAsync(2000);
  expect(spoken()).toBe('Lap 2 of 3');
  await live.setProps({ text: 'Off the track' });
  await vi.advanceTimersByTimeAsync(2000);
  const before = spoken();
  await live.setProps({ text: 'Boost!' });
  await live.setProps({ text: 'Lap 3 of 3' });
  await vi.advanceTimersByTimeAsync(1900);
  await live.setProps({ text: 'Place 2' });
  await vi.advanceTimersByTimeAsync(2000);
  expect([before, spoken()]).toEqual(['Off the track', 'Place 2']);
  live.unmount();
});

test('texts that change fast are not all read', async () => {
  const live = mount(LiveText, { props: { text: '0' } });
  const read = new Set<string>();
  for (let second = 1; second <= 40; second += 1) {
    await live.setProps({ text: String(second) });
    await vi.advanceTimersByTimeAsync(100);
    read.add(live.get('[role=status]').text());
  }
  expect(read.size).toBeLessThanOrEqual(4);
  live.unmount();
});
