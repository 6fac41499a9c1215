import type { MasterProcess, Member, Outsider } from '@ubii/harness';
import { AccessRole, encode } from '@ubii/proto';
import type { WebSocket } from 'ws';

import { pause } from '../../pause.ts';
import { comparison, finding, type Attack, type Finding } from '../attack.ts';
import type { AttackEnvironment } from '../environment/attack-environment.ts';

const CLIENTS = 5;

/** Use of a scarce resource by one player, and the check that others still get a share. */
interface Greed {
  readonly what: string;
  take(player: Outsider, member: Member, socket: WebSocket): Promise<void>;
  /** @throws Error when it gets none */
  want(caller: Outsider, member: Member, master: MasterProcess): Promise<void>;
}

export const shares: Attack = {
  name: 'shares',
  about: `${CLIENTS} clients of a player take all regular expressions and topics, then leave`,
  async run(environment) {
    const findings: Finding[] = [];
    for (const greed of [PATTERNS, TOPICS]) {
      const master = await environment.startMaster();
      findings.push(...(await tryGreed(environment, master, greed)));
      await environment.clear();
    }
    return findings;
  },
};

async function tryGreed(
  environment: AttackEnvironment,
  master: MasterProcess,
  greed: Greed,
): Promise<Finding[]> {
  const { what } = greed;
  const role = AccessRole.ACCESS_ROLE_PLAYER;
  const greedy = await environment.invite(master, role, { label: 'greedy' });
  const modest = await environment.invite(master, role, { label: 'modest' });
  const second = environment.outsider(master, 45);
  const admin = environment.insider(master);
  const others: [string, Outsider, Member][] = [
    ['a second player', second, await second.join(modest.token)],
    ['an admin', admin, await admin.join(undefined)],
  ];
  const sockets: WebSocket[] = [];
  for (let index = 0; index < CLIENTS; index++) {
    const player = environment.outsider(master, index);
    const member = await player.join(greedy.token);
    const socket = await player.openSocket(member);
    sockets.push(socket);
    await greed.take(player, member, socket).catch(() => {});
  }
  const taken = (await master.metrics()).get('ubii_topics') ?? 0;
  const findings: Finding[] = [comparison(`${what}: topics of the master then`, String(taken))];
  const ask = async (when: string): Promise<void> => {
    for (const [who, caller, member] of others) {
      const problem = await greed.want(caller, member, master).then(
        () => undefined,
        (error: unknown) => String((error as Error).message).slice(0, 90),
      );
      const isGiven = problem === undefined;
      findings.push(
        finding(`${what}: ${who} gets some ${when}`, isGiven ? 'yes' : 'no', 'yes', isGiven),
      );
    }
  };
  await ask('meanwhile');
  for (const socket of sockets) socket.terminate();
  await pause(5_000);
  await ask('5 s after they left');
  return findings;
}

const PATTERNS: Greed = {
  what: 'regular expressions',
  async take(player, { client, bearer }) {
    const subscribeTopicRegexp = Array.from({ length: 1_024 }, (_, i) => `^/${client.id}/${i}/x+$`);
    await subscribe(player, { client, bearer }, { subscribeTopicRegexp });
  },
  async want(caller, member) {
    const mine = `^/${member.client.id}/mine/${Math.random()}/[a-z]+$`;
    await subscribe(caller, member, { subscribeTopicRegexp: [mine] });
  },
};

const TOPICS: Greed = {
  what: 'topics',
  async take(_player, { client }, socket) {
    for (let at = 0; at < 131_072; at += 4_096) {
      const elements = Array.from({ length: 4_096 }, (_, i) => ({
        topic: `/${client.id}/${at + i}`,
        double: 1,
      }));
      socket.send(encode('ubii.topicData.TopicData', { topicDataRecordList: { elements } }));
      await pause(30);
    }
    await pause(2_000);
  },
  async want(caller, member, master) {
    const topic = `/${member.client.id}/mine/${Math.random()}`;
    const socket = await caller.openSocket(member);
    socket.send(encode('ubii.topicData.TopicData', { topicDataRecord: { topic, double: 1 } }));
    await pause(1_000);
    socket.terminate();
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    if (!stringList!.elements.includes(topic)) throw new Error('The topic was not made.');
  },
};

async function subscribe(
  caller: Outsider,
  { client, bearer }: Member,
  topicSubscription: { subscribeTopicRegexp: string[] },
): Promise<void> {
  const { error } = await caller.call(
    {
      topic: '/services/topic_subscription',
      topicSubscription: { clientId: client.id, ...topicSubscription },
    },
    bearer,
  );
  if (error !== undefined) throw new Error(error.message);
}
