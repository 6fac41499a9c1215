import type { MasterProcess } from '@ubii/harness';
import { describeTopicPort } from '@ubii/pm-sandbox/testing';
import { afterAll, beforeAll } from 'vitest';
import { createClient } from '../src/node.ts';
import type { UbiiClient } from '../src/index.ts';
import { ClientTopicPort } from '../src/processing/client-topic-port.ts';
import { DeviceTopics } from '../src/processing/device-topics.ts';
import { startOwnMaster } from './start-own-master.ts';

/** A whole process, on a machine that may be busy. */
const TIMEOUT_MS = 60_000;
let master: MasterProcess;
let tests = 0;

beforeAll(async () => {
  master = await startOwnMaster();
}, TIMEOUT_MS);
afterAll(async () => {
  await master.dispose();
});

describeTopicPort('a client of a real master', async () => {
  const root = `/test-${++tests}`;
  const own = createClient({
    url: master.url,
    name: 'node',
    publishIntervalMs: 0,
    node: { runsJavascript: true }, // else it is not told of what ends [TD-42]
  });
  const ada = createClient({ url: master.url, name: 'ada', publishIntervalMs: 0 });
  await Promise.all([own.connect(), ada.connect()]);
  const seen = new Map<string, Uint8Array>();
  ada.subscribeEncoded(
    { glob: `${root}/**` },
    {
      onRecord: ({ topic, bytes }) => void seen.set(topic, bytes),
      onGone: () => undefined,
    },
  );
  let settled = 0;
  /** Work that `settle` waits for. */
  let ending: Promise<void> | undefined;
  let sticks = 0;
  return {
    root,
    port: new ClientTopicPort(own, new DeviceTopics(own)),
    publisherId: ada.id,
    put: ({ topic, format, value }) =>
      ada.publish(topic, format, value as never, { immediate: true }),
    delete(topic) {
      ending = endTopic(ada, topic);
    },
    async settle() {
      await ending;
      const topic = `${root} settled ${settled++}`;
      await exchange(ada, own, `${topic} here`);
      await exchange(own, ada, `${topic} there`);
    },
    seenByOthers: (topic) => seen.get(topic),
    async addStick() {
      const component = {
        name: 'stick',
        format: 'vector2' as const,
        tags: ['stick'],
        ioType: 'publisher' as const,
      };
      const device = await ada.registerDevice({ name: `pad ${++sticks}`, components: [component] });
      return { topic: device.component('stick').topic, deviceId: device.id };
    },
    async close() {
      await Promise.all([own.close(), ada.close()]);
    },
  };
});

/**
 * Ensures that everything one client requested and published before has arrived when the other receives this record.
 */
async function exchange(from: UbiiClient, to: UbiiClient, topic: string): Promise<void> {
  const subscription = to.subscribe(topic);
  await subscription.ready;
  const received = new Promise<void>((resolve) => subscription.onRecord(() => resolve()));
  from.publish(topic, 'bool', true, { immediate: true });
  await received;
  await subscription.close();
}

/** A device that publishes on a topic takes the topic's value with it. [TD-40] */
async function endTopic(owner: UbiiClient, topic: string): Promise<void> {
  const component = { name: 'end', format: 'double' as const, topic };
  const device = await owner.registerDevice({ name: topic, components: [component] });
  await device.close();
}
