import { AccessRole, JoinProblem } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TRUSTED_CALLER } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';
import { codeOf, createGrant, join, joinAs, problemOf, revoke, stranger } from './access-world.ts';

const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER, ACCESS_ROLE_VIEWER } =
  AccessRole;
const HOUR_MS = 3_600_000;
const DAY_MS = 24 * HOUR_MS;

describe('an invitation', () => {
  it('shows its secrets once, and is listed without [AC-11] [AC-14]', async () => {
    const master = new TestMaster();
    const { grant, token, code } = await createGrant(master, ACCESS_ROLE_PLAYER, {
      label: 'Class 7b',
      target: '/devices/smart-device',
      maxJoins: 30,
      writeTopics: ['/game/**'],
    });
    expect(code).toMatch(/^[0-9A-HJKMNP-TV-Z]{4}-[0-9A-HJKMNP-TV-Z]{4}$/);
    const list = await master.call({ topic: '/services/ubii/access_grant_list' });
    expect(list.accessGrantList?.elements).toEqual([grant]);
    const kept = JSON.stringify([...master.grants.documents()].map(([, { json }]) => json));
    const told = JSON.stringify(list);
    for (const secret of [token, code]) expect(told).not.toContain(secret);
    // The plain secrets of tests say "hash of"; what they hash is not kept by itself.
    expect(kept.replaceAll(`hash of token ${token}`, '')).not.toContain(token);
  });

  it('admits with token and code, as what it says [AC-11] [AC-13] [AC-20]', async () => {
    const master = new TestMaster();
    const { token, code, grant } = await createGrant(master, ACCESS_ROLE_VIEWER);
    for (const secret of [token, code, code.toLowerCase().replace('-', ' ')]) {
      const { extension } = (await join(master, secret)).registered;
      expect(extension?.role).toBe(ACCESS_ROLE_VIEWER);
      expect(extension?.credentialExpiresMs).toBe(master.clock.nowMs() + 12 * HOUR_MS);
    }
    const list = await master.call({ topic: '/services/ubii/access_grant_list' });
    expect(list.accessGrantList?.elements[0]).toMatchObject({ id: grant!.id, joins: 3 });
    expect(list.accessGrantList?.elements[0]?.clientIds).toHaveLength(3);
    const report = await master.call({
      topic: '/services/ubii/client_report',
      clientReportRequest: {},
    });
    expect(report.clientReport?.clients[0]).toMatchObject({
      role: ACCESS_ROLE_VIEWER,
      grantId: grant!.id,
    });
  });

  it('does not admit clients that register without the extension [AC-13]', async () => {
    const master = new TestMaster();
    const { token } = await createGrant(master, ACCESS_ROLE_PARTICIPANT);
    expect(await problemOf(master, stranger(token), { name: 'old' })).toBe('failed_precondition');
  });

  it('says why not: wrong, expired, used up, revoked [AC-12]', async () => {
    const master = new TestMaster();
    const limited = await createGrant(master, ACCESS_ROLE_PLAYER, { maxJoins: 1 });
    const short = await createGrant(master, ACCESS_ROLE_PLAYER, { lifetimeMs: 1_000 });
    expect(await problemOf(master, stranger('x'.repeat(43)))).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    expect(await problemOf(master, stranger('u1.a.b.9e15.sig'))).toBe(
      JoinProblem.JOIN_PROBLEM_WRONG,
    );
    await join(master, limited.token);
    expect(await problemOf(master, stranger(limited.token))).toBe(JoinProblem.JOIN_PROBLEM_USED);
    expect(await problemOf(master, stranger(limited.code))).toBe(JoinProblem.JOIN_PROBLEM_USED);
    master.clock.advanceSync(1_001);
    expect(await problemOf(master, stranger(short.token))).toBe(JoinProblem.JOIN_PROBLEM_EXPIRED);
    await revoke(master, limited.grant!.id);
    expect(await problemOf(master, stranger(limited.token))).toBe(JoinProblem.JOIN_PROBLEM_REVOKED);
  });

  it('has a code for 12 hours, and a token for longer [AC-11]', async () => {
    const master = new TestMaster();
    const { token, code } = await createGrant(master, ACCESS_ROLE_PLAYER, {
      lifetimeMs: 2 * DAY_MS,
    });
    master.clock.advanceSync(12 * HOUR_MS);
    expect(await problemOf(master, stranger(code))).toBe(JoinProblem.JOIN_PROBLEM_EXPIRED);
    expect(await problemOf(master, stranger(token))).toBe(JoinProblem.JOIN_PROBLEM_NONE);
  });

  it.each([
    { role: 0 },
    { role: 9 },
    { label: 'a\nb' },
    { target: '//evil.example' },
    { target: '/\\evil.example' },
    { target: 'https://evil.example' },
    { lifetimeMs: -1 },
    { lifetimeMs: Number.NaN },
    { lifetimeMs: 31 * DAY_MS },
    { maxJoins: -1 },
    { role: ACCESS_ROLE_VIEWER, readTopics: ['/a'] },
    { writeTopics: [''] },
    { writeTopics: Array<string>(17).fill('/a') },
  ])('is not made of %j [AC-10]', async (wanted) => {
    const { error } = await new TestMaster().call({
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: { role: ACCESS_ROLE_PLAYER, ...wanted } as object,
    });
    expect(error?.code).toBe('invalid_argument');
  });

  it('is removed for another one when no client uses it [AC-10]', async () => {
    const master = new TestMaster({ limits: { grants: 2 } });
    const first = await createGrant(master, ACCESS_ROLE_PLAYER);
    await createGrant(master, ACCESS_ROLE_PLAYER);
    await expect(createGrant(master, ACCESS_ROLE_PLAYER)).rejects.toThrow(/limit grants/);
    await revoke(master, first.grant!.id);
    await createGrant(master, ACCESS_ROLE_PLAYER);
    expect(master.grants.documents().size).toBe(2);
  });
});

describe('checking a token [AC-16]', () => {
  const check = (master: TestMaster, token: string, caller = stranger()) =>
    master.call({ topic: '/services/ubii/join_check', joinCheckRequest: { token } }, caller);

  it('returns what it gives access to, without joining', async () => {
    const master = new TestMaster();
    const { token, code, grant } = await createGrant(master, ACCESS_ROLE_PLAYER, {
      target: '/a',
      maxJoins: 1,
    });
    for (const secret of [token, code]) {
      expect((await check(master, secret)).joinCheck).toMatchObject({
        role: ACCESS_ROLE_PLAYER,
        target: '/a',
        problem: JoinProblem.JOIN_PROBLEM_NONE,
        expiresMs: grant!.expiresMs,
        masterName: 'master-node',
      });
    }
    const phone = await join(master, token);
    // A client that joined with the grant is told so; for all others it is used up.
    for (const secret of [token, code, '']) {
      expect((await check(master, secret, phone.caller)).joinCheck).toMatchObject({
        role: ACCESS_ROLE_PLAYER,
        isJoined: true,
      });
    }
    const another = await createGrant(master, ACCESS_ROLE_PLAYER);
    const other = await join(master, another.token);
    expect((await check(master, another.token, phone.caller)).joinCheck?.isJoined).toBe(false);
    expect((await check(master, token, other.caller)).joinCheck).toMatchObject({
      role: 0,
      problem: JoinProblem.JOIN_PROBLEM_USED,
      message: expect.stringContaining('new one') as string,
    });
  });

  it('says what the caller may do', async () => {
    const master = new TestMaster();
    expect((await check(master, '', TRUSTED_CALLER)).joinCheck?.role).toBe(ACCESS_ROLE_ADMIN);
    const phone = await joinAs(master, ACCESS_ROLE_PLAYER, { target: '/a' });
    expect((await check(master, '', phone.caller)).joinCheck).toMatchObject({
      role: ACCESS_ROLE_PLAYER,
      target: '/a',
    });
  });
});

describe('a credential', () => {
  it('acts for its client alone [AC-22]', async () => {
    const master = new TestMaster();
    const ada = await joinAs(master, ACCESS_ROLE_ADMIN);
    const ben = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    for (const [client, other] of [
      [ada, ben],
      [ben, ada],
    ] as const) {
      const requests = [
        {
          topic: '/services/topic_subscription',
          topicSubscription: { clientId: other.id, subscribeTopics: ['/a'] },
        },
        { topic: '/services/device/registration', device: { clientId: other.id, name: 'd' } },
        { topic: '/services/device/deregistration', device: { clientId: other.id, id: 'd' } },
        { topic: '/services/client/deregistration', client: { id: other.id } },
        {
          topic: '/services/ubii/client_rename',
          clientRenameRequest: { clientId: other.id, targetId: client.id, name: 'x' },
        },
      ];
      for (const request of requests)
        expect(await codeOf(client, request)).toBe('permission_denied');
    }
    const rename = (targetId: string) => ({
      topic: '/services/ubii/client_rename',
      clientRenameRequest: { targetId, name: 'x' },
    });
    expect(await codeOf(ada, rename(ben.id))).toBe('');
    expect(await codeOf(ben, rename(ben.id))).toBe('');
    expect(await codeOf(ben, rename(ada.id))).toBe('permission_denied');
    expect(
      await codeOf(ben, {
        topic: '/services/ubii/client_disconnect',
        clientDisconnectRequest: { targetId: ada.id },
      }),
    ).toBe('permission_denied');
    expect(
      await codeOf(ben, {
        topic: '/services/ubii/client_throttle',
        clientThrottleRequest: { targetId: ben.id },
      }),
    ).toBe('permission_denied');
  });

  it('does not keep another client alive [CL-11] [AC-22]', async () => {
    const master = new TestMaster();
    const ada = await master.register({ name: 'ada', extension: {} });
    const ben = await joinAs(master, ACCESS_ROLE_PARTICIPANT);
    master.clock.advanceSync(6_000);
    await ben.call({ topic: '/services/device/get', device: { id: 'x', clientId: ada.id } });
    const { clientList } = await master.call({ topic: '/services/client/get_list' });
    expect(clientList?.elements.find(({ id }) => id === ada.id)?.state).toBe(1);
  });

  it('comes back as its client, and makes further ones, but no others [AC-18] [AC-23]', async () => {
    const master = new TestMaster();
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER, { maxJoins: 1 });
    const phone = await join(master, token);
    const as = (client: object, bearer = phone.caller.bearer) =>
      master.register(client, stranger(bearer));
    const back = { name: 'phone', id: phone.id, extension: { resumeToken: phone.token! } };
    expect((await as(back)).id).toBe(phone.id);
    // The token again, by who has joined with it.
    expect((await as(back, token)).id).toBe(phone.id);
    const tab = await as({ name: 'tab', extension: {} });
    expect(tab.id).not.toBe(phone.id);
    expect(tab.registered.extension?.role).toBe(ACCESS_ROLE_PLAYER);
    // A caller with a valid token of another client does not become that client.
    const ada = await master.extension('ada');
    const thief = await as({ name: 'x', id: ada.id, extension: { resumeToken: ada.token! } });
    expect(thief.id).not.toBe(ada.id);
    expect(await problemOf(master, stranger(token))).toBe(JoinProblem.JOIN_PROBLEM_USED);
  });

  it.each(['signature', 'grant', 'end'])(
    'is worth nothing with another %s [AC-13]',
    async (part) => {
      const master = new TestMaster();
      const phone = await joinAs(master, ACCESS_ROLE_PLAYER);
      const admins = await createGrant(master, ACCESS_ROLE_ADMIN);
      const [version, id, grant, end, signature] = phone.caller.bearer!.split('.');
      const forged = {
        signature: [version, id, grant, end, `${signature}A`],
        grant: [version, id, admins.grant!.id, end, signature],
        end: [version, id, grant, '99999999999999', signature],
      }[part]!.join('.');
      expect(await problemOf(master, stranger(forged))).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    },
  );

  it('lives for seven days, and is renewed as long as its invitation lets stay [AC-13] [AC-91]', async () => {
    const master = new TestMaster();
    const { token } = await createGrant(master, ACCESS_ROLE_PLAYER, {
      lifetimeMs: HOUR_MS,
      stayMs: 30 * DAY_MS,
    });
    let phone = await master.register({ name: 'phone', extension: {} }, stranger(token));
    const first = phone.caller;
    for (let day = 0; day < 28; day += 7) {
      master.clock.setWall(7 * DAY_MS - 1); // nothing else is to happen in these days
      phone = await master.register({ name: 'phone', extension: {} }, phone.caller);
    }
    expect(await problemOf(master, first)).toBe(JoinProblem.JOIN_PROBLEM_EXPIRED);
    expect(phone.registered.extension!.credentialExpiresMs).toBeLessThan(
      master.clock.nowMs() + 3 * DAY_MS,
    );
    master.clock.setWall(3 * DAY_MS);
    expect(await problemOf(master, phone.caller)).toBe(JoinProblem.JOIN_PROBLEM_EXPIRED);
  });

  it('stands after a restart, with id, role and invitations [AC-19] [AC-23]', async () => {
    const before = new TestMaster();
    const { token, grant } = await createGrant(before, ACCESS_ROLE_PLAYER, { maxJoins: 1 });
    const phone = await join(before, token);
    const master = new TestMaster({
      clock: before.clock,
      grants: before.grants,
      storage: before.storage,
    });
    expect(
      master.master.refuseConnection({ clientId: phone.id, token: phone.token }, stranger()),
    ).toBeUndefined();
    const back = await master.register(
      { name: 'phone', id: phone.id, extension: { resumeToken: phone.token! } },
      phone.caller,
    );
    expect(back.id).toBe(phone.id);
    expect(back.registered.extension?.role).toBe(ACCESS_ROLE_PLAYER);
    expect(await problemOf(master, stranger(token))).toBe(JoinProblem.JOIN_PROBLEM_USED);
    await revoke(master, grant!.id);
    const third = new TestMaster({ clock: before.clock, grants: before.grants });
    expect(await problemOf(third, phone.caller)).toBe(JoinProblem.JOIN_PROBLEM_REVOKED);
  });
});

describe('revoking [AC-15]', () => {
  it('ends sockets with a final code, and whatever was given', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const { token, code, grant } = await createGrant(master, ACCESS_ROLE_PLAYER);
    const phone = await join(master, token);
    const other = await joinAs(master, ACCESS_ROLE_PLAYER);
    await ada.call({
      topic: '/services/ubii/access_grant_revoke',
      accessGrantRevokeRequest: {
        clientId: ada.id,
        grantId: grant!.id,
        reason: 'the class is over',
      },
    });
    expect(phone.closed).toEqual({ reason: 'revoked', explanation: 'by ada: the class is over' });
    expect(other.closed).toBeUndefined();
    for (const secret of [token, code, phone.caller.bearer!]) {
      expect(await problemOf(master, stranger(secret))).toBe(JoinProblem.JOIN_PROBLEM_REVOKED);
    }
    // A client that was away is told on its next socket.
    expect(phone.open()).toBe(false);
    expect(phone.closed).toEqual({ reason: 'revoked', explanation: 'by ada: the class is over' });
    expect((await revoke(master, 'nothing')).error?.code).toBe('not_found');
  });
});

describe('sockets from other machines [AC-27]', () => {
  it('are opened for clients with a credential', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const old = await master.legacy('old');
    const phone = await joinAs(master, ACCESS_ROLE_PLAYER);
    const refused = (clientId: string | undefined, token?: string) =>
      master.master.refuseConnection({ clientId, token }, stranger()) !== undefined;
    expect(refused(phone.id, phone.token)).toBe(false);
    expect(refused(phone.id)).toBe(true);
    expect(refused(phone.id, ada.token)).toBe(true);
    expect(refused(ada.id, ada.token)).toBe(true);
    expect(refused(old.id)).toBe(true);
    expect(refused(undefined)).toBe(true);
    expect(refused('', 'x')).toBe(true);
    // Whatever the edge does, the core opens none.
    expect(ada.open(ada.token)).toBe(true);
    const handle = master.master.openConnection(
      { clientId: ada.id, token: ada.token },
      ada.connection,
      stranger(),
    );
    expect(handle).toBeUndefined();
  });
});

describe('the leave of the terminal [AC-19]', () => {
  it('is for participants, 12 hours, and replaced by the next run', async () => {
    const before = new TestMaster();
    const first = (await before.master.openTerminal(true)).join!;
    const phone = await join(before, first.token);
    expect(phone.registered.extension?.role).toBe(ACCESS_ROLE_PARTICIPANT);
    const master = new TestMaster({ clock: before.clock, grants: before.grants, idsGiven: 100 });
    const second = (await master.master.openTerminal(true)).join!;
    expect(await problemOf(master, stranger(first.token))).toBe(JoinProblem.JOIN_PROBLEM_EXPIRED);
    expect(await problemOf(master, phone.caller)).toBe(JoinProblem.JOIN_PROBLEM_NONE);
    const third = new TestMaster({ clock: before.clock, grants: before.grants, idsGiven: 200 });
    await third.master.openTerminal(true);
    // No client joined with the second, so that it was removed.
    expect(await problemOf(third, stranger(second.token))).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    // Its own two, and the first, with which a client has joined.
    expect(third.grants.documents().size).toBe(3);
  });
});

describe('many joining clients', () => {
  it('do not delay creating and revoking invitations [AC-15] [AC-19]', async () => {
    const master = new TestMaster();
    const { grants } = master;
    const { token, grant } = await createGrant(master, AccessRole.ACCESS_ROLE_PLAYER);
    const write = grants.write.bind(grants);
    const writes: (() => Promise<void>)[] = [];
    grants.write = (key, json) =>
      new Promise((resolve) => writes.push(() => write(key, json).then(resolve)));
    for (let i = 0; i < 100; i++) await join(master, token);
    expect(writes.length).toBe(1);
    while (writes.length > 0) {
      await writes.shift()!();
      await master.pass();
    }
    expect(JSON.stringify(grants.documents().get(grant!.id))).toContain('"joins":100');
  });
});
