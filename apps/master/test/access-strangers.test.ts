import { AccessRole, JoinProblem, SERVICES } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TRUSTED_CALLER } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';
import {
  codeOf,
  createGrant,
  joinAs,
  NETWORK_CALLER,
  problemOf,
  stranger,
} from './access-world.ts';

const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PLAYER } = AccessRole;
const REGISTRATION = {
  topic: '/services/client/registration',
  client: { name: 'x', extension: {} },
};

describe('strangers', () => {
  it('are told what to do, whatever service they call, and get three [AC-5] [AC-12]', async () => {
    const master = new TestMaster({ endpoints: { ipWlan: '10.0.0.1' } });
    for (const { topic } of Object.values(SERVICES)) {
      const { error, server, joinCheck } = await master.call(
        topic === SERVICES.joinCheck.topic
          ? { topic, joinCheckRequest: {} }
          : { topic, client: { name: 'x' } },
        stranger(),
      );
      if (topic === SERVICES.serverConfiguration.topic) {
        expect(server).toMatchObject({ ipWlan: '', ipEthernet: '', portServiceRest: '8102' });
        expect(JSON.stringify(server)).not.toContain('10.0.0.1');
      } else if (topic === SERVICES.joinCheck.topic) {
        expect(joinCheck?.problem).toBe(JoinProblem.JOIN_PROBLEM_MISSING);
      } else if (topic === SERVICES.masterProof.topic) {
        expect(error?.code).toBe('invalid_argument'); // without its payload
      } else if (error?.code !== 'unimplemented') {
        expect([topic, error?.code, error?.join?.problem]).toEqual([
          topic,
          'unauthenticated',
          JoinProblem.JOIN_PROBLEM_MISSING,
        ]);
        expect(error?.message).toContain('/join');
      }
    }
    expect([
      ...(await master.call({ topic: '/services/client/get_list' })).clientList!.elements,
    ]).toEqual([]);
  });

  it('of this machine are admins [AC-2] [AC-20]', async () => {
    const ada = await new TestMaster().extension('ada');
    expect(ada.registered.extension).toMatchObject({ role: ACCESS_ROLE_ADMIN, credential: '' });
  });

  it('with a token that is good for nothing are refused, also on this machine [AC-3]', async () => {
    const master = new TestMaster();
    const caller = { ...TRUSTED_CALLER, bearer: 'nonsense' };
    expect(await problemOf(master, caller)).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    const { server } = await master.call({ topic: '/services/server_configuration' }, caller);
    expect(server).toBeDefined();
  });

  it('of a network that is admitted are participants, for themselves [AC-4] [AC-22]', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada');
    const old = await master.register({ name: 'old' }, NETWORK_CALLER);
    expect(old.open()).toBe(true);
    expect(old.registered.extension).toBeUndefined();
    const subscribe = (clientId: string) =>
      codeOf(old, {
        topic: '/services/topic_subscription',
        topicSubscription: { clientId, subscribeTopics: ['/a'] },
      });
    expect(await subscribe(old.id)).toBe('');
    expect(await subscribe(ada.id)).toBe('permission_denied');
    expect(await codeOf(old, { topic: '/services/ubii/log_tail', logRequest: {} })).toBe(
      'permission_denied',
    );
    const phone = await joinAs(master, ACCESS_ROLE_PLAYER);
    expect(await subscribe(phone.id)).toBe('permission_denied');
    expect(
      master.master.refuseConnection({ clientId: ada.id, token: ada.token }, NETWORK_CALLER),
    ).toBeDefined();
  });
});

describe('guessing codes [AC-17]', () => {
  const wrong = (n: number) => `AAAA-${String(n).padStart(4, '0')}`;

  it('is slowed down, and a right code from the same address is taken a moment later', async () => {
    const master = new TestMaster();
    const { token, code } = await createGrant(master, ACCESS_ROLE_PLAYER);
    for (let i = 0; i < 20; i++) {
      expect(await problemOf(master, stranger(wrong(i)))).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    }
    expect(await problemOf(master, stranger(code))).toBe(JoinProblem.JOIN_PROBLEM_GUESSING);
    const check = { topic: '/services/ubii/join_check', joinCheckRequest: { token: code } };
    expect((await master.call(check, stranger())).joinCheck?.problem).toBe(
      JoinProblem.JOIN_PROBLEM_GUESSING,
    );
    const { error } = await master.call(REGISTRATION, stranger(code));
    expect(error).toMatchObject({ code: 'resource_exhausted' });
    expect(await problemOf(master, stranger(token))).toBe(JoinProblem.JOIN_PROBLEM_NONE);
    expect(await problemOf(master, stranger(code, '192.168.1.51'))).toBe(
      JoinProblem.JOIN_PROBLEM_NONE,
    );
    master.clock.advanceSync(1_000);
    expect(await problemOf(master, stranger(code))).toBe(JoinProblem.JOIN_PROBLEM_NONE);
  });

  it('from many addresses does not block other callers', async () => {
    const master = new TestMaster();
    const { code } = await createGrant(master, ACCESS_ROLE_PLAYER);
    for (let i = 0; i < 600; i++) await problemOf(master, stranger(wrong(i), `10.0.0.${i % 20}`));
    expect(await problemOf(master, stranger(code, '10.0.1.1'))).toBe(JoinProblem.JOIN_PROBLEM_NONE);
  });

  it('counts a call once', async () => {
    const master = new TestMaster({ limits: { wrongCodesPerAddress: 2 } });
    await createGrant(master, ACCESS_ROLE_PLAYER);
    for (let i = 0; i < 4; i++) {
      const { error } = await master.call({ ...REGISTRATION }, stranger(wrong(i)));
      expect(error?.join?.problem).toBe(JoinProblem.JOIN_PROBLEM_WRONG);
    }
    expect(await problemOf(master, stranger(wrong(4)))).toBe(JoinProblem.JOIN_PROBLEM_GUESSING);
  });
});
