import type { ComponentList, Device, ServiceRequest, Session } from '@ubii/proto';
import { describe, expect, expectTypeOf, it } from 'vitest';
import { ALL_SERVICES } from './all-services.ts';
import { definer, type ServicePayload } from './define-service.ts';

const define = definer<'clients'>();

describe('a defined service', () => {
  it('hands over the payload of its own member', () => {
    expectTypeOf<ServicePayload<'deviceGet'>>().toEqualTypeOf<Device>();
    expectTypeOf<ServicePayload<'serviceList'>>().toEqualTypeOf<undefined>();
    expectTypeOf<ServicePayload<'sessionDatabaseSave'>>().toEqualTypeOf<
      Pick<ServiceRequest, 'session' | 'sessionList'>
    >();
    expectTypeOf<ServicePayload<'componentGetList'>['componentList']>().toEqualTypeOf<
      ComponentList | undefined
    >();
    define('sessionPause', {
      roles: 'anyone',
      handle(core, session) {
        expectTypeOf(session).toEqualTypeOf<Session>();
        expectTypeOf(core).not.toHaveProperty('limits');
        return session;
      },
    });
  });

  it('names the client that asks from its own member alone [AC-22]', () => {
    const service = define('clientRename', {
      roles: ['admin'],
      subject: ({ clientId }) => clientId,
      handle: () => ({}),
    });
    const { topic } = service.info;
    const clientRenameRequest = { clientId: 'ada', targetId: 'ben', name: 'x' };
    expect(service.subjectOf({ topic, clientRenameRequest } as ServiceRequest)).toBe('ada');
    expect(
      service.subjectOf({ topic, device: { clientId: 'ada' } } as ServiceRequest),
    ).toBeUndefined();
    expect(service).toMatchObject({ actsForClient: true, audited: false });
  });

  it('is defined once', () => {
    const names = ALL_SERVICES.map(({ name }) => name);
    expect(new Set(names).size).toBe(names.length);
  });
});
