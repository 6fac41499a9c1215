import { AccessRole, JoinProblem } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { LOCAL_CALLER, TRUSTED_CALLER } from '../src/index.ts';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { codeOf, NETWORK_CALLER, problemOf, stranger } from './access-world.ts';

const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PARTICIPANT } = AccessRole;

/** A client of this machine that shows its credential from then on, as ours do. */
function joinHere(master: TestMaster, bearer: string): Promise<TestClient> {
  return master.register({ name: 'desk', extension: {} }, { ...LOCAL_CALLER, bearer });
}

describe('callers of this machine without a token [AC-2] [AC-40]', () => {
  it('are participants, existing clients included', async () => {
    const master = new TestMaster();
    const ours = await master.register({ name: 'ours', extension: {} }, LOCAL_CALLER);
    expect(ours.registered.extension?.role).toBe(ACCESS_ROLE_PARTICIPANT);
    expect(ours.registered.extension?.credential).toBe('');
    const existing = await master.register({ name: 'existing' }, LOCAL_CALLER);
    existing.open();
    expect(await codeOf(existing, { topic: '/services/client/get_list' })).toBe('');
    for (const topic of [
      '/services/ubii/access_grant_list',
      '/services/ubii/log_tail',
      '/services/ubii/setting_list',
    ]) {
      expect(await codeOf(existing, { topic })).toBe('permission_denied');
    }
  });

  it('act for one another, but not for clients with a credential', async () => {
    const master = new TestMaster();
    const { admin } = await master.master.openTerminal(false);
    const operator = await joinHere(master, admin.token);
    const trusted = await master.register({ name: 'trusted' }, TRUSTED_CALLER);
    const neighbour = await master.register({ name: 'neighbour' }, NETWORK_CALLER);
    const one = await master.register({ name: 'one' }, LOCAL_CALLER);
    const other = await master.register({ name: 'other' }, LOCAL_CALLER);
    const actFor = (clientId: string) =>
      codeOf(one, {
        topic: '/services/topic_subscription',
        topicSubscription: { clientId, subscribeTopics: ['/a'] },
      });
    expect([await actFor(one.id), await actFor(other.id)]).toEqual(['', '']);
    for (const { id } of [operator, trusted, neighbour]) {
      expect(await actFor(id)).toBe('permission_denied');
    }
    // The resume token identifies the owner of a socket; this is the check for a socket without one.
    const refuse = (clientId: string) =>
      master.master.refuseConnection({ clientId, token: undefined }, LOCAL_CALLER);
    expect(refuse(other.id)).toBeUndefined();
    for (const { id } of [operator, trusted, neighbour]) expect(refuse(id)).toBeDefined();
  });

  it('prove that they came in here by the resume token, and others do not [AC-27]', async () => {
    const master = new TestMaster();
    const { admin } = await master.master.openTerminal(false);
    const extension = {};
    const operator = await joinHere(master, admin.token);
    const trusted = await master.register({ name: 'trusted', extension }, TRUSTED_CALLER);
    const neighbour = await master.register({ name: 'neighbour', extension }, NETWORK_CALLER);
    const local = await master.register({ name: 'local', extension }, LOCAL_CALLER);
    const proves = (clientId: string, token: string | undefined) =>
      master.master.provesLocalClient({ clientId, token });
    const all = [trusted, local, neighbour, operator];
    expect(all.map(({ id, token }) => proves(id, token))).toEqual([true, true, false, false]);
    expect(all.map(({ token }) => token === undefined)).toEqual(all.map(() => false));
    for (const token of [undefined, '', 'nonsense', trusted.token]) {
      expect(proves(local.id, token)).toBe(false);
    }
    expect(proves('nobody', local.token)).toBe(false);
  });
});

describe('the leave of the operator [AC-42] [AC-43]', () => {
  it('makes admins on this machine only, with token, code and credential', async () => {
    const master = new TestMaster();
    const { admin, join } = await master.master.openTerminal(false);
    expect(join).toBeUndefined();
    for (const secret of [admin.token, admin.code]) {
      expect(await problemOf(master, stranger(secret))).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
      const check = { topic: '/services/ubii/join_check', joinCheckRequest: { token: secret } };
      expect((await master.call(check, stranger())).joinCheck?.problem).toBe(
        JoinProblem.JOIN_PROBLEM_WRONG,
      );
      const operator = await joinHere(master, secret);
      expect(operator.registered.extension?.role).toBe(ACCESS_ROLE_ADMIN);
      expect(await codeOf(operator, { topic: '/services/ubii/setting_list' })).toBe('');
      const { credential } = operator.registered.extension!;
      const stolen = await master.call({ topic: '/services/ubii/log_tail' }, stranger(credential));
      expect(stolen.error?.join?.problem).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    }
  });

  it('has a new token and code at each start, and keeps joined clients', async () => {
    const before = new TestMaster();
    const first = await before.master.openTerminal(true);
    const operator = await joinHere(before, first.admin.token);
    const master = new TestMaster({ clock: before.clock, grants: before.grants, idsGiven: 100 });
    const second = await master.master.openTerminal(true);
    for (const secret of [first.admin.token, first.admin.code]) {
      expect(await problemOf(master, { ...LOCAL_CALLER, bearer: secret })).toBe(
        JoinProblem.JOIN_PROBLEM_WRONG,
      );
    }
    expect(await problemOf(master, operator.caller)).toBe(JoinProblem.JOIN_PROBLEM_NONE);
    expect(await problemOf(master, { ...LOCAL_CALLER, bearer: second.admin.code })).toBe(
      JoinProblem.JOIN_PROBLEM_NONE,
    );
    const { accessGrantList } = await master.call({ topic: '/services/ubii/access_grant_list' });
    const admins = accessGrantList!.elements.filter(({ role }) => role === ACCESS_ROLE_ADMIN);
    expect(admins).toMatchObject([{ label: 'This machine', isTerminal: true, joins: 2 }]);
  });
});
