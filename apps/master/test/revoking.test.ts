import {
  AccessRole,
  JoinProblem,
  RevokedWork,
  SessionState,
  type AccessGrant,
  type Init,
  type Session,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { createGrant, join, problemOf, stranger } from './access-world.ts';
import { doubler, doubling, TOPICS } from './sessions/session-world.ts';

const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER } = AccessRole;
const { REVOKED_WORK_HAND_OVER } = RevokedWork;
const { SESSION_RUNNING, SESSION_STOPPED } = SessionState;
const HOUR_MS = 3_600_000;

/** An invited client that has created objects. */
class Guest {
  readonly master: TestMaster;
  readonly client: TestClient;
  readonly grantId: string;

  private constructor(master: TestMaster, client: TestClient, grantId: string) {
    this.master = master;
    this.client = client;
    this.grantId = grantId;
  }

  static async join(
    master: TestMaster,
    wanted: Parameters<typeof createGrant>[2] = {},
  ): Promise<Guest> {
    const { grant, token } = await createGrant(master, ACCESS_ROLE_PARTICIPANT, wanted);
    return new Guest(master, await join(master, token, 'guest'), grant!.id);
  }

  /** Asks for something about a session in the guest's name. */
  async ask(topic: string, session: Init<Session>): Promise<Session> {
    const { session: reply, sessionList, error } = await this.client.call({ topic, session });
    if (error) throw new Error(error.message);
    await this.master.pass();
    return reply ?? sessionList!.elements[0]!;
  }
}

async function stateOf(master: TestMaster, { id }: Pick<Session, 'id'>): Promise<SessionState> {
  const { session } = await master.call({ topic: TOPICS.get, session: { id } });
  return session!.extension!.state;
}

async function listed(master: TestMaster, id: string): Promise<AccessGrant> {
  const { accessGrantList } = await master.call({ topic: '/services/ubii/access_grant_list' });
  return accessGrantList!.elements.find((grant) => grant.id === id)!;
}

async function revoke(master: TestMaster, grantId: string, work?: RevokedWork) {
  const { accessGrant } = await master.call({
    topic: '/services/ubii/access_grant_revoke',
    accessGrantRevokeRequest: { grantId, ...(work !== undefined && { work }) },
  });
  await master.pass();
  return accessGrant!;
}

/** The master of the next run. */
function restarted({ clock, grants, storage }: TestMaster): TestMaster {
  return new TestMaster({ clock, grants, storage, idsGiven: 500 });
}

const lasting = (from: string, to: string): Init<Session> => ({
  ...doubling(from, to),
  extension: { startWithMaster: true },
});

describe('what was made with an invitation [AC-90]', () => {
  it('is listed with it: sessions, which of them run, stored ones, modules', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master);
    const made = await guest.ask(TOPICS.add, doubling('/a', '/b'));
    const running = await guest.ask(TOPICS.start, { ...doubling('/c', '/d'), name: 'second' });
    await guest.ask(TOPICS.save, { ...doubling('/e', '/f'), name: 'kept' });
    await guest.client.call({
      topic: TOPICS.saveModule,
      processingModule: { ...doubler, name: 'own doubler' },
    });
    const { session: own } = await master.call({
      topic: TOPICS.start,
      session: doubling('/g', '/h'),
    });
    expect(own!.extension!.grantIds).toEqual([]);
    const grant = await listed(master, guest.grantId);
    expect(grant.sessionIds).toEqual(expect.arrayContaining([made.id, running.id]));
    expect(grant.sessionIds).not.toContain(own!.id);
    expect(grant).toMatchObject({
      runningSessionIds: [running.id],
      storedSessionNames: ['kept'],
      moduleNames: ['own doubler'],
    });
    // It stands after a restart.
    expect(await listed(restarted(master), guest.grantId)).toMatchObject({
      storedSessionNames: ['kept'],
      moduleNames: ['own doubler'],
    });
  });

  it('includes sessions of other clients that a guest changed, or that use a module of a guest', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master);
    const { session: own } = await master.call({
      topic: TOPICS.start,
      session: doubling('/a', '/b'),
    });
    await guest.ask(TOPICS.update, { ...own!, description: 'mine now' });
    await guest.client.call({
      topic: TOPICS.saveModule,
      processingModule: { ...doubler, name: 'of a guest' },
    });
    const { session: using } = await master.call({
      topic: TOPICS.start,
      session: { name: 'using', processingModules: [{ name: 'of a guest' }] },
    });
    expect((await listed(master, guest.grantId)).sessionIds).toEqual([own!.id, using!.id]);
  });

  it('cannot be claimed or denied by the request', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master);
    const session = await guest.ask(TOPICS.start, {
      ...doubling('/a', '/b'),
      extension: { grantIds: ['other'] },
    });
    expect(session.extension!.grantIds).toEqual([guest.grantId]);
  });
});

describe('revoking [AC-92]', () => {
  it('stops sessions unless it is told otherwise, also after a restart, and keeps them', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master);
    const session = await guest.ask(TOPICS.start, lasting('/a', '/b'));
    const other = await Guest.join(master);
    const foreign = await other.ask(TOPICS.start, lasting('/c', '/d'));
    const reply = await revoke(master, guest.grantId);
    expect(reply).toMatchObject({ sessionIds: [session.id], runningSessionIds: [] });
    expect(await stateOf(master, session)).toBe(SESSION_STOPPED);
    expect(await stateOf(master, foreign)).toBe(SESSION_RUNNING);
    const next = restarted(master);
    await next.pass();
    const { sessionList } = await next.call({ topic: TOPICS.list });
    expect(sessionList!.elements.map(({ id }) => id)).toEqual([foreign.id]);
  });

  it('transfers sessions, stored sessions and modules, which continue to run', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master);
    const session = await guest.ask(TOPICS.start, lasting('/a', '/b'));
    await guest.ask(TOPICS.save, { ...doubling('/e', '/f'), name: 'kept' });
    await guest.client.call({
      topic: TOPICS.saveModule,
      processingModule: { ...doubler, name: 'own doubler' },
    });
    const grant = await revoke(master, guest.grantId, REVOKED_WORK_HAND_OVER);
    expect(grant).toMatchObject({ sessionIds: [], storedSessionNames: [], moduleNames: [] });
    expect(guest.client.closed?.reason).toBe('revoked');
    expect(await stateOf(master, session)).toBe(SESSION_RUNNING);
    const next = restarted(master);
    await next.pass();
    expect(await stateOf(next, session)).toBe(SESSION_RUNNING);
    expect(await listed(next, guest.grantId)).toMatchObject({ moduleNames: [] });
  });

  it('revokes the invitations that were made with it [AC-93]', async () => {
    const master = new TestMaster();
    const first = await createGrant(master, ACCESS_ROLE_ADMIN);
    const admin = await join(master, first.token, 'admin');
    const { accessGrantCreated } = await admin.call({
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: { role: ACCESS_ROLE_ADMIN },
    });
    const friend = await join(master, accessGrantCreated!.token, 'friend');
    await revoke(master, first.grant!.id);
    expect(friend.closed?.reason).toBe('revoked');
    expect(await problemOf(master, stranger(accessGrantCreated!.token))).toBe(
      JoinProblem.JOIN_PROBLEM_REVOKED,
    );
  });
});

describe('the time of an invitation [AC-91]', () => {
  it('ends joined clients, too: their sockets close with a code of their own, their sessions stop', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master, { lifetimeMs: 2_000 });
    const session = await guest.ask(TOPICS.start, lasting('/a', '/b'));
    expect(guest.client.registered.extension!.credentialExpiresMs).toBeLessThanOrEqual(
      (await listed(master, guest.grantId)).staysUntilMs,
    );
    await master.pass(4_000);
    expect(guest.client.closed).toEqual({ reason: 'expired' });
    expect(await problemOf(master, guest.client.caller)).toBe(JoinProblem.JOIN_PROBLEM_EXPIRED);
    expect(await stateOf(master, session)).toBe(SESSION_STOPPED);
    // The caller that starts it again owns it: it is not stopped a second time.
    await master.call({ topic: TOPICS.start, session: { id: session.id } });
    await master.pass(4_000);
    expect(await stateOf(master, session)).toBe(SESSION_RUNNING);
  });

  it('may be longer for joined clients than for joining ones', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master, { lifetimeMs: 2_000, stayMs: HOUR_MS });
    const session = await guest.ask(TOPICS.start, lasting('/a', '/b'));
    await master.pass(4_000);
    expect(guest.client.closed).toBeUndefined();
    expect(await stateOf(master, session)).toBe(SESSION_RUNNING);
    expect(await problemOf(master, guest.client.caller)).toBe(JoinProblem.JOIN_PROBLEM_NONE);
  });

  it('ends while the master does not run: nothing comes back', async () => {
    const master = new TestMaster();
    const guest = await Guest.join(master, { lifetimeMs: 2_000 });
    await guest.ask(TOPICS.start, lasting('/a', '/b'));
    await master.master.close();
    master.clock.advanceSync(10_000);
    const next = restarted(master);
    await next.pass();
    const { sessionList } = await next.call({ topic: TOPICS.list });
    expect(sessionList!.elements.map(({ extension }) => extension!.state)).toEqual([
      SessionState.SESSION_CREATED,
    ]);
    const third = restarted(next);
    expect((await third.call({ topic: TOPICS.list })).sessionList!.elements).toEqual([]);
  });

  it('is refused when it is too long', async () => {
    const master = new TestMaster();
    await expect(
      createGrant(master, ACCESS_ROLE_PLAYER, { stayMs: 31 * 24 * HOUR_MS }),
    ).rejects.toThrow('stay_ms');
  });
});
