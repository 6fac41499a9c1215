import { AccessRole, decode, encode, type ClusterMessage, type Init } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { CLUSTER_VERSION } from '../../src/core/cluster/members.ts';
import type { TestMaster } from '../../src/testing/index.ts';
import { clusterOf, type ClusterWorld } from './cluster-world.ts';

const FORGER = 'forger';

/** A program at NATS that is no master: it sends what it likes, and keeps what it gets. */
function joinAsForger({ hub }: ClusterWorld) {
  const bus = hub.bus();
  const got: Uint8Array[] = [];
  bus.listen(FORGER, {
    handleMessage: (_from, bytes) => got.push(bytes),
    handleReach() {},
  });
  const say = (to: TestMaster | undefined, message: Init<ClusterMessage>): void => {
    const bytes = encode('ubii.extension.ClusterMessage', message);
    if (to === undefined) bus.broadcast(bytes);
    else bus.send(to.master.id, bytes);
  };
  return { bus, got, say };
}

/** A request that is said to come from a trusted program of the machine of the sender. */
function trustedCall(): Init<ClusterMessage> {
  const request = encode('ubii.services.ServiceRequest', {
    topic: '/services/ubii/access_grant_create',
    accessGrantCreateRequest: { role: AccessRole.ACCESS_ROLE_ADMIN },
  });
  return { call: { number: 1, request, standing: 'trusted', place: 'here', isHere: true } };
}

const HELLO = { hello: { version: CLUSTER_VERSION, name: 'forged' } };
const masterCount = ({ master }: TestMaster): number | undefined =>
  master.metrics().find(({ name }) => name === 'ubii_cluster_masters')?.values[0]?.value;

describe('[CU-65] a program that does not have the key of the cluster', () => {
  it('is no master, and gets no invitation, whatever it says of its caller', async () => {
    const [world, a, b] = await clusterOf(2);
    const forger = joinAsForger(world);
    forger.say(undefined, HELLO);
    forger.say(a, trustedCall());
    await world.pass(3_000);
    expect([masterCount(a!), world.grants.documents().size]).toEqual([1, 0]);
    const kinds = forger.got.map((bytes) => decode('ubii.extension.ClusterMessage', bytes));
    expect(kinds.filter(({ hello }) => hello === undefined)).toEqual([]);
    const warnings = b!.log.lines.filter(({ message }) => message.includes('key of the cluster'));
    expect(warnings).toHaveLength(1);
  });

  it('is not answered for messages of masters that it sends again', async () => {
    const [world, a, b] = await clusterOf(2);
    const forger = joinAsForger(world);
    await world.pass(1_000);
    const helloOfB = forger.got.find((bytes) =>
      decode('ubii.extension.ClusterMessage', bytes).hello?.name.includes('2'),
    );
    forger.got.length = 0;
    forger.bus.send(a!.master.id, helloOfB!);
    await world.pass(1_000);
    expect([masterCount(a!), masterCount(b!)]).toEqual([1, 1]);
    const listens = forger.got.filter(
      (bytes) => decode('ubii.extension.ClusterMessage', bytes).listen !== undefined,
    );
    expect(listens).toEqual([]);
  });
});
