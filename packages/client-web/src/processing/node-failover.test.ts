import { SessionState } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { expect, it } from 'vitest';
import { FakeMaster } from '../testing/fake-master.ts';
import { FakeSessions } from '../testing/fake-sessions.ts';
import { createNodeWorld, rest, sessionOf, timesTen } from '../testing/node-world.ts';

it('[CU-83] a node that moves registers as a node, reports its modules, and runs them on', async () => {
  const other = new FakeMaster();
  const otherSessions = new FakeSessions(other);
  const first = new FakeMaster();
  first.masters = ['http://b'];
  const others = new Map([['http://b', other]]);
  const world = await createNodeWorld({}, first, { url: 'http://a', others });
  const { client, clock, node, sessions } = world;
  const module = timesTen(client.id);
  sessions.start(sessionOf(module));
  await rest();
  const [instance] = node.instances;

  otherSessions.put(sessionOf(module), SessionState.SESSION_RUNNING); // the masters share it
  first.stop();
  await clock.advance(6_000);
  await rest();
  expect(client.masterUrl).toBe('http://b');
  expect(other.requests.find((each) => each.client !== undefined)?.client).toMatchObject({
    id: client.id,
    extension: { node: {} },
  });
  expect(otherSessions.told).toEqual(['add m1']);
  expect(node.instances.map(({ id }) => id)).toEqual([instance?.id]);
  other.publish({ topic: '/m1/in', format: 'double', value: 4 });
  await rest();
  await settle();
  expect(other.published.map(({ topic, value }) => [topic, value])).toEqual([['/m1/out', 40]]);
});
