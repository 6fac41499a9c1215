import { readFileSync } from 'node:fs';
import {
  AccessRole,
  clientTopic,
  ComponentIOType,
  FAREWELL_TOPIC,
  identifyTopic,
  messageDescriptor,
  preflightTopic,
  type Init,
  type ServiceRequest,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { withRights } from '../scripts/rights-page.ts';
import {
  mayCall,
  TOPIC_RIGHTS,
  type TopicKind,
  type TopicRight,
} from '../src/core/access/rights-table.ts';
import type { GivenRole } from '../src/core/access/roles.ts';
import { ALL_SERVICES } from '../src/core/services/all-services.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { joinAs, stranger } from './access-world.ts';

const WIRE: { readonly [R in GivenRole]: AccessRole } = {
  viewer: AccessRole.ACCESS_ROLE_VIEWER,
  player: AccessRole.ACCESS_ROLE_PLAYER,
  participant: AccessRole.ACCESS_ROLE_PARTICIPANT,
  admin: AccessRole.ACCESS_ROLE_ADMIN,
};
const ROLES = Object.keys(WIRE) as GivenRole[];

describe('the page of the rights', () => {
  it('is made from the definitions and tables; `npm run generate` makes it again', () => {
    const page = readFileSync(new URL('../../../docs/security.md', import.meta.url), 'utf8');
    expect(page).toBe(withRights(page));
  });
});

/** Their payloads name a client that is looked for. */
const ABOUT_CLIENTS = ['auditLog', 'deviceGet'];

it('a service whose payload names a client says whether it is the caller [AC-22]', () => {
  const members = messageDescriptor('ubii.services.ServiceRequest').fieldByName;
  const silent = ALL_SERVICES.filter(({ name, info, actsForClient }) => {
    const type = info.request === undefined ? undefined : members.get(info.request)?.type;
    const isMessage = typeof type === 'object' && type.kind === 'message';
    const namesClient = isMessage && type.fieldByName.has('clientId');
    return namesClient && !actsForClient && !ABOUT_CLIENTS.includes(name);
  });
  expect(
    silent.map(({ name }) => name),
    'client_id is the caller: define `subject`, or call another client target_id',
  ).toEqual([]);
});

describe('services, in both directions [AC-21]', () => {
  it.each(ROLES)('%s', async (role) => {
    const master = new TestMaster();
    const client = await joinAs(master, WIRE[role]);
    for (const service of ALL_SERVICES) {
      const { topic } = service.info;
      const { error } = await client.call({ topic });
      const isRefused = error?.code === 'permission_denied';
      expect([topic, isRefused]).toEqual([topic, !mayCall(service, role)]);
    }
  });

  it('stranger', async () => {
    const master = new TestMaster();
    for (const service of ALL_SERVICES) {
      const { name, info } = service;
      const { topic } = info;
      const payloads: Partial<Record<typeof name, Init<ServiceRequest>>> = {
        joinCheck: { joinCheckRequest: {} },
        masterProof: { masterProofRequest: {} },
      };
      const payload = payloads[name] ?? { client: { name: 'x' } };
      const { error } = await master.call({ topic, ...payload }, stranger());
      const isRefused = error?.code === 'unauthenticated';
      // The registration is open to everybody who shows a token.
      const isOpen = mayCall(service, 'none') && name !== 'clientRegistration';
      expect([topic, isRefused]).toEqual([topic, !isOpen]);
    }
  });
});

/** A client of the role under test, an admin, and another client with a subscribing component. */
interface World {
  readonly master: TestMaster;
  readonly ada: TestClient;
  readonly client: TestClient;
  readonly other: TestClient;
}

async function createWorld(role: GivenRole): Promise<World> {
  const master = new TestMaster();
  const ada = await joinAs(master, AccessRole.ACCESS_ROLE_ADMIN);
  const other = await joinAs(master, AccessRole.ACCESS_ROLE_PLAYER);
  const granted = { writeTopics: ['/granted/*'], readTopics: ['/granted/*'] };
  const client = await joinAs(master, WIRE[role], role === 'player' ? granted : {});
  const topic = `/${other.id}/pad/vibrate`;
  await other.call({
    topic: '/services/device/registration',
    device: {
      clientId: other.id,
      name: 'pad',
      components: [{ topic, ioType: ComponentIOType.SUBSCRIBER }],
    },
  });
  return { master, ada, client, other };
}

/** Topics of each kind; only those that clients could publish are ever free of values. */
const EXAMPLES: { readonly [K in TopicKind]: (world: World) => readonly string[] } = {
  ownState: ({ client }) => [clientTopic(client.id)],
  granted: () => ['/granted/a'],
  master: ({ other }) => ['/info/device/new', 'info/x', '/ubii/x', clientTopic(other.id)],
  ownPreflight: ({ client }) => [preflightTopic(client.id)],
  own: ({ client }) => [`/${client.id}/x`, `${client.id}/x`, `${client.id}/preflight`],
  farewell: () => [FAREWELL_TOPIC],
  identify: ({ other }) => [identifyTopic(other.id)],
  inputOfOther: ({ other }) => [`/${other.id}/pad/vibrate`],
  other: ({ other }) => [`/${other.id}/pad/touch`, `${other.id}/orientation`],
  elsewhere: ({ client }) => [
    '/shared',
    'shared',
    `/${client.id}`,
    `//${client.id}/x`,
    '/grantedx',
  ],
};

const rows = (Object.entries(TOPIC_RIGHTS) as [TopicKind, TopicRight][]).flatMap(([kind, row]) =>
  ROLES.filter((role) => kind !== 'granted' || role === 'player').map((role) => ({
    kind,
    role,
    publish: row.publish.includes(role),
    receive: row.receive.includes(role),
  })),
);

describe('topics, in both directions [AC-24] [AC-25] [TD-16]', () => {
  it.each(rows)('$role, $kind: publish $publish', async ({ role, kind, publish }) => {
    const world = await createWorld(role);
    const { client, master } = world;
    for (const topic of EXAMPLES[kind](world)) {
      master.clock.advanceSync(200); // Errors are sent at a rate.
      client.takeErrors();
      client.publish(topic, 'string', client.id);
      expect([topic, client.takeErrors().length === 0]).toEqual([topic, publish]);
    }
  });

  it.each(rows)('$role, $kind: receive $receive', async ({ role, kind, receive }) => {
    const world = await createWorld(role);
    const { client, ada } = world;
    await client.subscribe({ subscribeTopicRegexp: ['.*'] });
    client.takeSent();
    for (const topic of EXAMPLES[kind](world)) {
      ada.publish(topic, 'string', 'x');
      // Only the master publishes on its topics: nothing comes there.
      if (kind !== 'master' && kind !== 'ownState') {
        const received = client.takeRecords().map((record) => record.topic);
        expect(received).toEqual(receive ? [topic] : []);
      }
      const subscribed = client.subscribe({ subscribeTopics: [topic] }).then(
        () => true,
        () => false,
      );
      expect([topic, await subscribed]).toEqual([topic, receive]);
      client.takeSent();
    }
  });
});
