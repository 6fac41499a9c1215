import { dialLoopback, type MasterProcess, type Member, Outsider } from '@ubii/harness';
import { encode, type Client } from '@ubii/proto';
import type { WebSocket } from 'ws';

import { pause } from '../../pause.ts';
import type { Random } from '../../random.ts';
import type { Counters } from './counters.ts';

const RECORDS = 20;

/** Master of the simulated phones, and their join token. */
export interface PhoneSetup {
  readonly master: MasterProcess;
  readonly counters: Counters;
  readonly random: Random;
  token: string;
}

/** One phone: it joins, is a device, loses its connection, comes back, and leaves or is gone. */
export async function runPhone(setup: PhoneSetup): Promise<void> {
  const { master, counters, random } = setup;
  const phone = new Outsider({
    host: '127.0.0.1',
    port: master.port,
    from: '127.0.0.1',
    headers: {},
    dial: () => dialLoopback(master.port),
  });
  let member = await phone.join(setup.token, { name: 'phone' });
  let socket = await phone.openSocket(member);
  counters.done('phones joined');
  try {
    await registerDevice(phone, member);
    await publish(socket, member.client);
    if (random.oneIn(2)) {
      socket.terminate();
      await pause(random.below(100));
      member = await comeBack(phone, member);
      socket = await phone.openSocket(member);
      counters.done('phones back');
      await publish(socket, member.client);
    }
    if (random.oneIn(8)) {
      counters.done('phones gone silently');
      return;
    }
    const { error } = await phone.call(
      { topic: '/services/client/deregistration', client: { id: member.client.id } },
      member.bearer,
    );
    if (error !== undefined) throw new Error(error.message);
    counters.done('phones left');
  } finally {
    socket.terminate();
  }
}

/** Registers the device of a phone, with three components. */
export async function registerDevice(phone: Outsider, { client, bearer }: Member): Promise<void> {
  const { error } = await phone.call(
    {
      topic: '/services/device/registration',
      device: {
        name: 'smart device',
        clientId: client.id,
        components: ['touch', 'orientation', 'acceleration'].map((name) => ({
          name,
          topic: `/${client.id}/${name}`,
          messageFormat: 'ubii.dataStructure.Vector3',
          tags: [name],
        })),
      },
    },
    bearer,
  );
  if (error !== undefined) throw new Error(error.message);
}

async function comeBack(phone: Outsider, { client, bearer }: Member): Promise<Member> {
  const { resumeToken = '' } = client.extension ?? {};
  const member = await phone.join(bearer, { id: client.id, extension: { resumeToken } });
  if (member.client.id !== client.id) throw new Error('A phone reconnected with another id.');
  return member;
}

/** Publishes values of its components, one after the other. */
export async function publish(
  socket: WebSocket,
  { id }: Client,
  records: number = RECORDS,
): Promise<void> {
  for (let index = 0; index < records; index++) {
    const topic = `/${id}/${['touch', 'orientation', 'acceleration'][index % 3]}`;
    const topicDataRecord = { topic, vector3: { x: index, y: 0, z: 0 } };
    socket.send(encode('ubii.topicData.TopicData', { topicDataRecord }));
    await pause(2);
  }
}
