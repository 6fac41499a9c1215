import type { TopicRecord } from '@ubii/proto';
import { expect, it } from 'vitest';
import { effectScope, nextTick, reactive, ref, shallowRef } from 'vue';
import type { Seen } from '../../devices/camera/seeing-session.ts';
import { EMPTY_MS } from '../pictures/empty-results.ts';
import type { PictureSources } from '../pictures/usePictureSource.ts';
import { useNotFound } from './useNotFound.ts';

function results(count: number, timestampMs: number): TopicRecord {
  const elements = Array.from({ length: count }, () => ({ id: 'one' }));
  const value = { elements } as TopicRecord<'object2DList'>['value'];
  return { topic: '/found', format: 'object2DList', value, timestampMs, clientId: '' };
}

it('tells what is looked for when no module finds anything, and nothing when one of them does', async () => {
  const sources = {
    kind: ref('clip'),
    clip: ref('photos'),
    topic: ref(''),
  } as unknown as PictureSources;
  const found = shallowRef<ReadonlyMap<Seen, TopicRecord>>(new Map());
  const looksFor = reactive({ objects: true, bodies: false, hands: true });
  const scope = effectScope();
  const notFound = scope.run(() => useNotFound(sources, { found, looksFor }))!;
  const find = async (objects: number, hands: number, timestampMs: number): Promise<void> => {
    found.value = new Map([
      ['objects', results(objects, timestampMs)],
      ['hands', results(hands, timestampMs)],
    ]);
    await nextTick();
  };
  await find(0, 1, 0);
  await find(0, 1, EMPTY_MS);
  expect(notFound.value).toBeUndefined();
  await find(0, 0, EMPTY_MS + 1);
  await find(0, 0, 2 * EMPTY_MS + 1);
  expect(notFound.value).toEqual({
    wanted: ['objects', 'hands'],
    sentence: 'No objects and no hands were found in the last seconds.',
  });
  scope.stop();
});
