import { readyPatterns } from '@ubii/patterns';
import { Re2Patterns } from '@ubii/patterns/re2';
import { expect, it } from 'vitest';
import type { ClientOptions } from './core/client/client-options.ts';
import type { UbiiClient } from './core/client/ubii-client.ts';
import { createClientOver } from './create-client.ts';
import { FakeMaster } from './testing/fake-master.ts';
import { createMemoryServices, createMemoryTopicData } from './transports/memory.ts';

/** A client whose WebSocket cannot be opened, and what it tried to open. */
function create(options: Partial<ClientOptions>): { client: UbiiClient; opened: string[] } {
  const opened: string[] = [];
  const client = createClientOver(
    { name: 'ada', ...options },
    readyPatterns(new Re2Patterns()),
    (url) => {
      opened.push(url);
      throw new Error('no network');
    },
    undefined,
  );
  return { client, opened };
}

it('uses both transports of the options, without a URL', async () => {
  const master = new FakeMaster();
  const { client, opened } = create({
    transports: {
      services: createMemoryServices(master),
      topicData: createMemoryTopicData(master),
    },
  });
  await client.connect();
  expect(opened).toEqual([]);
  await client.close();
});

it('uses the WebSocket when the options bring services only', async () => {
  const { client, opened } = create({
    url: 'http://master:8080',
    reconnect: { giveUpAfterAttempts: 1 },
    transports: { services: createMemoryServices(new FakeMaster()) },
  });
  await expect(client.connect()).rejects.toMatchObject({ name: 'ConnectionError' });
  expect(opened[0]).toMatch(/^ws:\/\/master:8080\/topicdata\?/);
});

it('needs a URL for the transport that the options lack', () => {
  const topicData = createMemoryTopicData(new FakeMaster());
  expect(() => create({ transports: { topicData } })).toThrow(TypeError);
});
