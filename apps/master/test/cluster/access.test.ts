import { AccessRole, JoinProblem, type JsonObject } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { LOCAL_CALLER } from '../../src/index.ts';
import type { TestClient, TestMaster } from '../../src/testing/index.ts';
import { createGrant, join, NETWORK_CALLER, problemOf, revoke, stranger } from '../access-world.ts';
import { ClusterWorld, clusterOf } from './cluster-world.ts';

const { ACCESS_ROLE_PLAYER } = AccessRole;

/** Two masters with a terminal each, and what that of the first one shows its operator. */
async function twoTerminals() {
  const world = new ClusterWorld();
  const a = await world.add({ installation: 'a' });
  const b = await world.add({ installation: 'b' });
  const { admin } = await a.master.openTerminal(true);
  await b.master.openTerminal(true);
  world.tellGrants();
  return { world, a, b, admin };
}

/** Has a client disconnected. @returns the code of the error; empty when that is done */
async function disconnect(world: ClusterWorld, by: TestClient, targetId: string): Promise<string> {
  const replied = by.call({
    topic: '/services/ubii/client_disconnect',
    clientDisconnectRequest: { clientId: by.id, targetId },
  });
  await world.pass(100);
  return (await replied).error?.code ?? '';
}

function auditOf({ audit }: TestMaster): JsonObject[] {
  return audit.lines.map((line) => JSON.parse(line) as JsonObject);
}

/** A world whose two masters do not hear each other any more, after they did. */
async function apart(world: ClusterWorld): Promise<void> {
  world.setReachable(world.masters[0]!, false);
  await world.pass(5_000);
}

describe('access in a cluster', () => {
  it('[CU-27] invitations are good at every master', async () => {
    const [world, a, b] = await clusterOf(2);
    const { token } = await createGrant(a!, ACCESS_ROLE_PLAYER);
    world.tellGrants();
    const phone = await join(b!, token);
    expect(phone.registered.extension?.role).toBe(ACCESS_ROLE_PLAYER);
  });

  it('[CU-27] what one master revokes ends at all', async () => {
    const [world, a, b] = await clusterOf(2);
    const { token, grant } = await createGrant(a!, ACCESS_ROLE_PLAYER);
    world.tellGrants();
    const atA = await join(a!, token);
    const atB = await join(b!, token);
    await world.pass();
    await revoke(a!, grant!.id);
    world.tellGrants();
    await world.pass();
    expect([atA.closed?.reason, atB.closed?.reason]).toEqual(['revoked', 'revoked']);
    expect(await problemOf(b!, stranger(token))).toBe(JoinProblem.JOIN_PROBLEM_REVOKED);
  });

  it('[CU-21] a player has no more rights at a new master than its role gives', async () => {
    const [world, a, b] = await clusterOf(2);
    const { token } = await createGrant(a!, ACCESS_ROLE_PLAYER);
    world.tellGrants();
    const phone = await join(a!, token);
    await world.pass();
    await apart(world);
    const { credential, resumeToken } = phone.registered.extension!;
    const back = await b!.register(
      { name: 'phone', id: phone.id, extension: { resumeToken } },
      stranger(credential),
    );
    expect([back.id, back.open()]).toEqual([phone.id, true]);
    const screen = await b!.extension('screen');
    await screen.subscribe({ subscribeTopicRegexp: ['.*'] });
    back.publish('/elsewhere', 'double', 1);
    back.publish(`/${phone.id}/pad`, 'double', 2);
    await world.pass();
    const topics = screen.takeValues().map(([topic]) => topic);
    expect(topics).toContain(`/${phone.id}/pad`);
    expect(topics).not.toContain('/elsewhere');
    expect(back.takeErrors()[0]?.code).toBe('permission_denied');
  });

  it('[CU-21] a client of an admitted network comes back as what it was', async () => {
    const [world, a, b] = await clusterOf(2);
    const phone = await a!.register({ name: 'phone', extension: {} }, NETWORK_CALLER);
    phone.open();
    await world.pass();
    await apart(world);
    const { resumeToken } = phone.registered.extension!;
    const back = await b!.register(
      { name: 'phone', id: phone.id, extension: { resumeToken } },
      NETWORK_CALLER,
    );
    expect([back.id, back.open()]).toEqual([phone.id, true]);
    expect(back.registered.extension?.role).toBe(AccessRole.ACCESS_ROLE_PARTICIPANT);
  });

  it('[CU-27] the terminal of one master does not close that of another', async () => {
    const world = new ClusterWorld();
    const a = await world.add({ installation: 'a' });
    const { join: atA } = await a.master.openTerminal(true);
    world.tellGrants();
    const b = await world.add({ installation: 'b' });
    await b.master.openTerminal(true);
    world.tellGrants();
    expect(await problemOf(a, stranger(atA!.token))).toBe(JoinProblem.JOIN_PROBLEM_NONE);
    const again = await world.add({ installation: 'a' });
    await again.master.openTerminal(true);
    world.tellGrants();
    expect(await problemOf(b, stranger(atA!.token))).toBe(JoinProblem.JOIN_PROBLEM_EXPIRED);
  });

  it('[AC-43] [CU-27] the token and code of a terminal are worth nothing at other masters, on their machines too', async () => {
    const { a, b, admin } = await twoTerminals();
    for (const bearer of [admin.token, admin.code]) {
      const caller = { ...LOCAL_CALLER, bearer };
      expect(await problemOf(b, caller)).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
      const operator = await a.register({ name: 'desk', extension: {} }, caller);
      const { credential, role } = operator.registered.extension!;
      expect(role).toBe(AccessRole.ACCESS_ROLE_ADMIN);
      const copied = await b.call(
        { topic: '/services/ubii/log_tail' },
        { ...LOCAL_CALLER, bearer: credential },
      );
      expect(copied.error?.join?.problem).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    }
  });

  it('[AC-43] [CU-28] [EX-91] the operator of one master disconnects a client of another, whose audit log says from where', async () => {
    const { world, a, b, admin } = await twoTerminals();
    const robot = await b.extension('robot');
    const operator = await a.register(
      { name: 'desk', extension: {} },
      { ...LOCAL_CALLER, bearer: admin.token },
    );
    await world.pass();
    expect(await disconnect(world, operator, robot.id)).toBe('');
    expect(robot.closed?.reason).toBe('disconnected');
    expect(auditOf(b)).toMatchObject([{ way: 'GRANT', masterName: 'master 1' }]);
    expect(auditOf(a)).toEqual([]);
  });

  it('[EX-91] a caller without a token that another master trusts is no caller of this machine in the audit log', async () => {
    const [world, a, b] = await clusterOf(2);
    const robot = await b!.extension('robot');
    const program = await a!.extension('program');
    await world.pass();
    expect(await disconnect(world, program, robot.id)).toBe('');
    const [entry] = auditOf(b!);
    expect(entry).toMatchObject({ way: 'CLUSTER', masterName: 'master 1' });
    expect(entry?.addressKind).not.toBe('LOOPBACK');
  });

  it('[CU-28] a request is refused where the caller asks, before it is carried', async () => {
    const [world, a, b] = await clusterOf(2);
    const robot = await a!.extension('robot');
    await world.pass();
    const { error } = await b!.call(
      {
        topic: '/services/ubii/client_disconnect',
        clientDisconnectRequest: { targetId: robot.id },
      },
      stranger(),
    );
    expect(error?.code).toBe('unauthenticated');
    expect(robot.closed).toBeUndefined();
  });

  it('[CU-28] a client of another master is renamed and disconnected there', async () => {
    const [world, a, b] = await clusterOf(2);
    const robot = await a!.extension('robot');
    const admin = await b!.extension('admin');
    await world.pass();
    const ask = async (topic: string, payload: object) => {
      const replied = admin.call({ topic, ...payload });
      await world.pass(100);
      return replied;
    };
    await ask('/services/ubii/client_rename', {
      clientRenameRequest: { clientId: admin.id, targetId: robot.id, name: 'arm' },
    });
    await world.pass(100);
    const { clientList } = await b!.call({ topic: '/services/client/get_list', clientList: {} });
    expect(clientList?.elements.map(({ name }) => name).sort()).toEqual(['admin', 'arm']);
    await ask('/services/ubii/client_disconnect', {
      clientDisconnectRequest: { clientId: admin.id, targetId: robot.id, reason: 'test' },
    });
    expect(robot.closed?.reason).toBe('disconnected');
  });

  it('[CU-27] a revocation is not taken back by a master that did not know of it', async () => {
    const [world, a, b] = await clusterOf(2);
    const { token, grant } = await createGrant(a!, ACCESS_ROLE_PLAYER);
    world.tellGrants();
    const before = JSON.stringify(world.grants.documents().get(grant!.id)!.json);
    await revoke(a!, grant!.id);
    // The other master counted a client that joined, and wrote what it knew.
    world.grants.edit(grant!.id, before.replace('"joins":0', '"joins":1'));
    await world.pass();
    expect(await problemOf(a!, stranger(token))).toBe(JoinProblem.JOIN_PROBLEM_REVOKED);
    world.tellGrants();
    expect(await problemOf(b!, stranger(token))).toBe(JoinProblem.JOIN_PROBLEM_REVOKED);
  });
});
