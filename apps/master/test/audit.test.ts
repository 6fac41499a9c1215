import { AccessRole, AuditEntryWay, type AuditLogRequest, type Init } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster, type TestClient } from '../src/testing/index.ts';
import { createGrant, join, stranger } from './access-world.ts';

const session = {
  name: 'Lights',
  processingModules: [{ name: 'm', onProcessingStringified: '() => ({})' }],
};

async function read(master: TestMaster, auditLogRequest: Init<AuditLogRequest> = { count: 100 }) {
  const { auditLog, error } = await master.call({
    topic: '/services/ubii/audit_log',
    auditLogRequest,
  });
  expect(error).toBeUndefined();
  return auditLog!;
}
const addSession = (client: TestClient, name = 'Lights') =>
  client.call({ topic: '/services/session/runtime/add', session: { ...session, name } });

/** A master with a participant of an invitation. */
async function createRoom(options: ConstructorParameters<typeof TestMaster>[0] = {}) {
  const master = new TestMaster(options);
  const { grant, token } = await createGrant(master, AccessRole.ACCESS_ROLE_PARTICIPANT, {
    label: 'Class 7b',
  });
  const ben = await join(master, token, 'Ben');
  return { master, grant: grant!, ben };
}

describe('the audit log', () => {
  it('records actor, action, time, invitation and result [EX-90] [EX-91]', async () => {
    const { master, grant, ben } = await createRoom();
    const { session: added } = await addSession(ben);
    await ben.call({ topic: '/services/session/runtime/remove', session: { id: added!.id } });
    await ben.call({ topic: '/services/session/runtime/start', session: { id: 'nowhere' } });
    const { entries, more } = await read(master);
    expect(more).toBe(false);
    const who = {
      clientId: ben.id,
      clientName: 'Ben',
      role: AccessRole.ACCESS_ROLE_PARTICIPANT,
      way: AuditEntryWay.GRANT,
      grantId: grant.id,
      grantLabel: 'Class 7b',
      timeMs: master.clock.nowMs(),
    };
    expect(entries).toMatchObject([
      { ...who, service: '/services/session/runtime/start', object: 'nowhere', error: 'not_found' },
      { ...who, service: '/services/session/runtime/remove', object: 'Lights', error: '' },
      { ...who, service: '/services/session/runtime/add', object: 'Lights', error: '' },
      {
        service: '/services/ubii/access_grant_create',
        object: 'Class 7b',
        way: AuditEntryWay.LOCAL,
        grantId: '',
      },
    ]);
    const numbers = entries.map(({ number }) => number);
    expect(numbers).toEqual([...numbers].sort((a, b) => b - a));
  });

  it('has both names of a session that gets another one [EX-91]', async () => {
    const { master, ben } = await createRoom();
    const { session: added } = await addSession(ben, 'Session');
    const renamed = { ...session, id: added!.id, name: 'Arm lights' };
    await ben.call({ topic: '/services/session/runtime/update', session: renamed });
    await ben.call({ topic: '/services/session/database/save', session: renamed });
    const next = { ...renamed, name: 'Lamps' };
    await ben.call({ topic: '/services/session/database/save', session: next });
    const objects = (await read(master)).entries.slice(0, 3).map(({ object }) => object);
    expect(objects).toEqual(['Arm lights → Lamps', 'Arm lights', 'Session → Arm lights']);
  });

  it('has what was refused for want of rights, but nothing of strangers [EX-90]', async () => {
    const { master, ben } = await createRoom();
    await ben.call({
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: { clientId: ben.id, role: AccessRole.ACCESS_ROLE_ADMIN },
    });
    const before = (await read(master)).entries;
    expect(before[0]).toMatchObject({ clientName: 'Ben', error: 'permission_denied' });
    await master.call({ topic: '/services/session/runtime/add', session }, stranger());
    expect((await read(master)).entries).toHaveLength(before.length);
  });

  it('has nothing of those who only look or publish, and no secret [EX-90] [EX-91]', async () => {
    const { master, ben } = await createRoom();
    const { kept } = await read(master);
    ben.publish('/light', 'double', 1);
    await ben.call({ topic: '/services/session/runtime/get_list' });
    await ben.subscribe({ subscribeTopics: ['/light'] });
    expect((await read(master)).kept).toBe(kept);
    const { credential, resumeToken } = ben.registered.extension!;
    const text = master.audit.lines.join('\n');
    for (const secret of [credential, resumeToken]) expect(text).not.toContain(secret);
  });

  it('is for admins [EX-93]', async () => {
    const { ben } = await createRoom();
    const { error } = await ben.call({ topic: '/services/ubii/audit_log', auditLogRequest: {} });
    expect(error?.code).toBe('permission_denied');
  });

  it('comes in pages, and finds by client, invitation, service and words [EX-93]', async () => {
    const { master, grant, ben } = await createRoom();
    for (let i = 0; i < 7; i++) await addSession(ben, `s${i}`);
    const first = await read(master, { count: 3 });
    expect(first.entries.map(({ object }) => object)).toEqual(['s6', 's5', 's4']);
    expect(first.more).toBe(true);
    const next = await read(master, { count: 100, before: first.entries.at(-1)!.number });
    expect(next.entries.map(({ object }) => object)).toEqual(['s3', 's2', 's1', 's0', 'Class 7b']);
    expect(next.more).toBe(false);
    const objects = async (request: Init<AuditLogRequest>) =>
      (await read(master, request)).entries.map(({ object }) => object);
    expect(await objects({ text: 'BEN s3' })).toEqual(['s3']);
    expect(await objects({ clientId: ben.id, count: 1 })).toEqual(['s6']);
    expect(await objects({ grantId: grant.id, count: 2 })).toEqual(['s6', 's5']);
    expect(await objects({ service: 'access_grant' })).toEqual(['Class 7b']);
    expect(await objects({ text: 'unknown' })).toEqual([]);
  });

  it('outlives the master, with a line that was cut off [EX-92]', async () => {
    const { master, ben } = await createRoom();
    await addSession(ben);
    const { entries } = await read(master);
    master.audit.lines.push('{"number":99', 'null', '{}');
    const next = new TestMaster({
      clock: master.clock,
      audit: master.audit,
      grants: master.grants,
    });
    expect((await read(next)).entries).toEqual(entries);
    await createGrant(next, AccessRole.ACCESS_ROLE_VIEWER, { label: 'later' });
    const [newest] = (await read(next)).entries;
    expect(newest).toMatchObject({ object: 'later', number: entries[0]!.number + 1 });
  });

  it('is bounded, by caller too, and says what was left out [EX-94]', async () => {
    const { master, ben } = await createRoom({
      limits: { auditEntries: 150, auditEntriesPerSecond: 1 },
    });
    const flood = async (times: number) => {
      for (let i = 0; i < times; i++) {
        await ben.call({
          topic: '/services/session/runtime/start',
          session: { id: 'x', name: 'y'.repeat(250) },
        });
      }
    };
    await flood(500);
    const { kept, entries } = await read(master, { count: 500 });
    expect(kept).toBe(61); // a minute of them, and the invitation
    master.clock.advanceSync(1_000);
    await flood(1);
    expect((await read(master)).entries[0]).toMatchObject({ leftOut: 440 });
    for (const line of master.audit.lines) expect(line.length).toBeLessThan(2_048);
    // Others are not touched by it.
    await createGrant(master, AccessRole.ACCESS_ROLE_VIEWER, { label: 'other' });
    expect((await read(master)).entries[0]).toMatchObject({ object: 'other', leftOut: 0 });
    expect(entries[0]!.object.length).toBeLessThanOrEqual(200);
    for (let i = 0; i < 200; i++) {
      master.clock.advanceSync(1_000);
      await flood(1);
    }
    expect((await read(master)).kept).toBe(150);
  });

  it('keeps its entries when one client joins repeatedly [EX-94]', async () => {
    const { master } = await createRoom({
      limits: { auditEntries: 1_000, auditEntriesPerSecond: 1 },
    });
    const { token } = await createGrant(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    for (let i = 0; i < 20; i++) {
      const guest = await join(master, token, `guest ${i}`);
      for (let k = 0; k < 60; k++) {
        await guest.call({ topic: '/services/session/runtime/start', session: { id: 'x' } });
      }
    }
    const { kept } = await read(master, { count: 500 });
    expect(kept).toBeGreaterThan(8 * 60);
    expect(kept).toBeLessThan(8 * 60 + 10);
  });
});
