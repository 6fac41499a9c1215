import { expect, it } from 'vitest';
import { effectScope, nextTick, ref } from 'vue';
import { useEndedSentence } from './useEndedSentence.ts';

const RESTARTED = /^The master was restarted\. The topic has had no value since\./;
const ENDED = /^The topic no longer has a value\./;

it('tells a restart of the master from the end of a value', async () => {
  const topic = ref('/a');
  const count = ref(0);
  const masterMs = ref<number>();
  const scope = effectScope();
  const sentence = scope.run(() =>
    useEndedSentence(
      () => topic.value,
      () => count.value,
      () => masterMs.value,
    ),
  )!;
  count.value = 1;
  await nextTick();
  // The state of the master may arrive after the record.
  masterMs.value = 1000;
  await nextTick();
  expect(sentence.value).toMatch(ENDED);
  masterMs.value = 2000;
  await nextTick();
  expect(sentence.value).toMatch(RESTARTED);
  count.value = 2;
  await nextTick();
  expect(sentence.value).toMatch(ENDED);
  scope.stop();
});
