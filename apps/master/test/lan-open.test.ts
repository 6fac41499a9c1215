import { AccessRole } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';

const TOPIC = '/services/ubii/lan_open';

describe('turning on the local network [AC-47]', () => {
  it('an admin on the machine of the master turns it on, which the audit log has', async () => {
    const master = new TestMaster();
    const { success, error } = await master.call({ topic: TOPIC });
    expect(error).toBeUndefined();
    expect(success).toBeDefined();
    expect(master.lan.isOpen).toBe(true);
    const { auditLog } = await master.call({
      topic: '/services/ubii/audit_log',
      auditLogRequest: { count: 10 },
    });
    expect(auditLog!.entries).toMatchObject([{ service: TOPIC, error: '' }]);
  });

  it('succeeds without a change when it is on', async () => {
    const master = new TestMaster();
    await master.call({ topic: TOPIC });
    master.lan.problem = 'opened twice';
    expect((await master.call({ topic: TOPIC })).success).toBeDefined();
  });

  it('an admin on another machine cannot turn it on', async () => {
    const master = new TestMaster();
    const remote = await joinAs(master, AccessRole.ACCESS_ROLE_ADMIN);
    expect((await remote.call({ topic: TOPIC })).error).toMatchObject({
      code: 'failed_precondition',
    });
    expect(master.lan.isOpen).toBe(false);
  });

  it.each([
    AccessRole.ACCESS_ROLE_PARTICIPANT,
    AccessRole.ACCESS_ROLE_PLAYER,
    AccessRole.ACCESS_ROLE_VIEWER,
  ])('role %s cannot turn it on', async (role) => {
    const master = new TestMaster();
    const client = await joinAs(master, role);
    expect((await client.call({ topic: TOPIC })).error).toMatchObject({
      code: 'permission_denied',
    });
    expect(master.lan.isOpen).toBe(false);
  });

  it('returns the reason when a port cannot be had', async () => {
    const master = new TestMaster();
    master.lan.problem = 'Port 8080 (--port) is taken by another program.';
    const { error } = await master.call({ topic: TOPIC });
    expect(error).toMatchObject({ code: 'unavailable' });
    expect(error!.message).toContain('Port 8080 (--port) is taken');
  });
});
