// @vitest-environment happy-dom
import type { TopicRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { effectScope, nextTick, ref, shallowRef } from 'vue';
import { TopicHistory } from './topic-history.ts';
import { useHistoryView } from './useTopicHistory.ts';

const record = (value: number): TopicRecord =>
  ({ topic: '/lab/speed', format: 'double', value }) as TopicRecord;

it('shows a value that only the past has: the retained record was a part of it', async () => {
  const history = shallowRef(new TopicHistory());
  const isPaused = ref(false);
  const scope = effectScope();
  const { shown } = scope.run(() => useHistoryView(history, isPaused))!;
  const earlier = history.value.before(1);
  earlier.add(record(3), 1000);
  history.value.beginWith(earlier);
  isPaused.value = true;
  await nextTick();
  expect(shown.value.latest?.value).toBe(3);

  // Paused, so the next record waits.
  history.value.add(record(4), 2000);
  isPaused.value = false;
  isPaused.value = true;
  await nextTick();
  expect(shown.value.latest?.value).toBe(3);
  isPaused.value = false;
  await nextTick();
  expect(shown.value.latest?.value).toBe(4);
  scope.stop();
});
