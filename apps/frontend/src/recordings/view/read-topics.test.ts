import type { UbiiClient } from '@ubii/client-web';
import { expect, it, vi } from 'vitest';
import { readTopics } from './read-topics.ts';

/** A client of a master with so many topics in a recording, three on a page. */
function clientOf(total: number) {
  const call = vi.fn((_service: string, { topicsFrom = 0 }: { readonly topicsFrom?: number }) => {
    const all = Array.from({ length: total }, (_, index) => ({ topic: `/${index}` }));
    const topics = all.slice(topicsFrom, topicsFrom + 3);
    return Promise.resolve({ topics, topicsFrom, topicsTotal: total });
  });
  return { call, client: { call } as unknown as Pick<UbiiClient, 'call'> };
}

it('[RC-54] reads all pages of topics', async () => {
  const { client, call } = clientOf(7);
  const topics = await readTopics(client, 'a');
  expect(topics.map(({ topic }) => topic)).toEqual(['/0', '/1', '/2', '/3', '/4', '/5', '/6']);
  expect(call).toHaveBeenCalledTimes(3);
});

it('reads one page of a recording without topics', async () => {
  const { client, call } = clientOf(0);
  expect(await readTopics(client, 'a')).toEqual([]);
  expect(call).toHaveBeenCalledTimes(1);
});
