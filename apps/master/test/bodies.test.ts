import { AccessRole, SERVICES, type ServiceName } from '@ubii/proto';
import { describe, expect, it } from 'vitest';

import { DEFAULT_LIMITS, type CallerFacts, type Limits } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';

const KIB = 1024;
const LOCAL: CallerFacts = {
  standing: 'trusted',
  isHere: true,
  place: 'here',
  bearer: undefined,
};
const stranger = (place: string): CallerFacts => ({
  standing: 'other',
  isHere: false,
  place,
  bearer: undefined,
});
const neighbour = (place: string): CallerFacts => ({ ...stranger(place), standing: 'network' });

function open(master: TestMaster, caller: CallerFacts, connection: object = {}) {
  return master.master.openRequest(caller, connection);
}

function bytesInFlight(master: TestMaster): number | undefined {
  return master.master.metrics().find(({ name }) => name === 'ubii_request_bytes_in_flight')
    ?.values[0]?.value;
}

function hits(master: TestMaster, limit: string): number | undefined {
  return master.master
    .metrics()
    .find(({ name }) => name === 'ubii_limit_hits_total')
    ?.values.find(({ labels }) => labels['limit'] === limit)?.value;
}

async function codeFor(master: TestMaster): Promise<string> {
  return (await master.master.openTerminal(true)).join!.code;
}

describe('the limits of a body', () => {
  it('[SV-42] are those of its service', () => {
    const request = open(new TestMaster(), LOCAL);
    const { sessionBytes, serviceBodyBytes, serviceValues, largeServiceValues } = DEFAULT_LIMITS;
    const bytesOf = (name: ServiceName) => request.limitsOf(SERVICES[name].topic)?.bytes;
    expect(bytesOf('topicList')).toBe(serviceBodyBytes);
    expect(bytesOf('sessionRuntimeAdd')).toBe(1.5 * sessionBytes);
    expect(bytesOf('processingModuleDatabaseSave')).toBe(1.5 * sessionBytes);
    expect(bytesOf('clientDeregistration')).toBe(1.5 * DEFAULT_LIMITS.registrationBytesPerClient);
    expect(bytesOf('topicSubscription')).toBe(DEFAULT_LIMITS.subscriptionBodyBytes);
    expect(request.limitsOf(SERVICES.logTail.topic)?.values).toBe(serviceValues);
    expect(request.limitsOf(SERVICES.sessionRuntimeAdd.topic)?.values).toBe(largeServiceValues);
    expect(request.largest.bytes).toBe(1.5 * sessionBytes);
  });

  it('[SV-42] grow with the limits on what is stored', () => {
    const master = new TestMaster({ limits: { sessionBytes: 100 * KIB * KIB } });
    expect(open(master, LOCAL).largest.bytes).toBe(150 * KIB * KIB);
  });

  it('[SV-41] are none where there is no such service, or not for this caller', () => {
    const master = new TestMaster();
    expect(open(master, LOCAL).limitsOf('/services/nonsense')).toBeUndefined();
    expect(open(master, stranger('a')).limitsOf(SERVICES.topicList.topic)).toBeUndefined();
    const joinCheck = open(master, stranger('a')).limitsOf(SERVICES.joinCheck.topic);
    expect(joinCheck?.bytes).toBe(DEFAULT_LIMITS.strangerBodyBytes);
  });

  it('[SV-41] are those of the service for a client with an invitation that names its sender', async () => {
    const master = new TestMaster();
    const phone = await joinAs(master, AccessRole.ACCESS_ROLE_PARTICIPANT);
    const bearer = phone.registered.extension?.credential;
    const request = open(master, { ...stranger('a'), bearer });
    expect(request.caller.kind).toBe('client');
    expect(request.limitsOf(SERVICES.topicSubscription.topic)).toBeDefined();
  });

  it('[SV-40] are smaller for callers that are not registered', async () => {
    const master = new TestMaster();
    expect(open(master, stranger('a')).largest.bytes).toBe(DEFAULT_LIMITS.strangerBodyBytes);
    const joining = open(master, { ...stranger('a'), bearer: await codeFor(master) });
    expect(joining.caller.kind).toBe('joining');
    expect(joining.largest.bytes).toBe(DEFAULT_LIMITS.joiningBodyBytes);
  });
});

describe('the caller', () => {
  it('[SV-40] is found once: a wrong code counts once for a request', async () => {
    const master = new TestMaster({ limits: { wrongCodesPerAddress: 1 } });
    const right = await codeFor(master);
    for (let i = 0; i < 2; i++) {
      const wrong = { ...stranger('a'), bearer: `ZZZZ-ZZZ${i}` };
      const incoming = open(master, wrong);
      const answer = await master.master.handleServiceRequest(
        { topic: SERVICES.topicList.topic },
        wrong,
        incoming,
      );
      expect(answer.reply.error).toMatchObject({ code: 'unauthenticated' });
    }
    expect(open(master, { ...stranger('a'), bearer: right }).caller.kind).toBe('joining');
  });
});

describe('bytes in flight', () => {
  const few: Partial<Limits> = {
    bodyBytes: 1000,
    bodyBytesPerClient: 400,
    bodyBytesPerConnection: 300,
    bodyBytesOfStrangers: 100,
    bodyBytesPerAddress: 60,
  };

  it('[SV-46] are counted once, and given back once', () => {
    const master = new TestMaster();
    const request = open(master, LOCAL);
    request.reserve(1000);
    request.reserve(500);
    request.reserve(2000);
    expect(bytesInFlight(master)).toBe(2000);
    request.release();
    request.release();
    expect(bytesInFlight(master)).toBe(0);
  });

  it.each([
    ['bodyBytesPerAddress', stranger('a'), stranger('a'), [40, 40]],
    ['bodyBytesOfStrangers', stranger('a'), stranger('b'), [60, 60]],
    ['bodyBytesPerClient', neighbour('a'), neighbour('a'), [300, 300]],
    ['bodyBytes', LOCAL, LOCAL, [500, 500]],
  ] as const)('[SV-46] have the limit %s', (limit, first, second, [one, two]) => {
    const master = new TestMaster({ limits: few });
    const before = open(master, first);
    before.reserve(one);
    const request = open(master, second);
    expect(() => request.reserve(two)).toThrow(limit);
    expect(hits(master, limit)).toBe(1);
    expect(bytesInFlight(master)).toBe(one);
    before.release();
    request.reserve(two);
    expect(bytesInFlight(master)).toBe(two);
  });

  it('[SV-46] have a limit for each connection', () => {
    const master = new TestMaster({ limits: few });
    const connection = {};
    open(master, LOCAL, connection).reserve(200);
    expect(() => open(master, LOCAL, connection).reserve(200)).toThrow('bodyBytesPerConnection');
    open(master, LOCAL).reserve(200);
  });

  it('[SV-46] leave room for this machine when all others send, and the other way round', () => {
    const master = new TestMaster({ limits: few });
    for (const place of ['a', 'b']) open(master, neighbour(place)).reserve(300);
    expect(() => open(master, neighbour('c')).reserve(300)).toThrow('bodyBytes');
    open(master, LOCAL).reserve(250);
    const other = new TestMaster({ limits: few });
    open(other, LOCAL).reserve(700);
    expect(() => open(other, LOCAL).reserve(100)).toThrow('bodyBytes');
    open(other, neighbour('c')).reserve(250);
  });

  it('[SV-46] let one request pass that is larger than what its caller may have at once', () => {
    const master = new TestMaster({ limits: { ...few, bodyBytesPerClient: 1 } });
    open(master, neighbour('a')).reserve(250);
    expect(() => open(master, neighbour('a')).reserve(250)).toThrow('bodyBytesPerClient');
  });

  it('[SV-46] say when to try again', async () => {
    const master = new TestMaster({ limits: few });
    open(master, stranger('a')).reserve(60);
    try {
      open(master, stranger('a')).reserve(60);
    } catch (error) {
      expect(master.master.refuseServiceRequest(error)).toMatchObject({
        retryAfterS: 1,
        reply: { error: { code: 'resource_exhausted' } },
      });
    }
    expect.assertions(1);
    await Promise.resolve();
  });

  it('[EX-36] are in the list of limits', async () => {
    const master = new TestMaster();
    open(master, stranger('a')).reserve(600);
    const { limitList } = await master.call({ topic: SERVICES.limitList.topic });
    const use = (name: string) => limitList?.elements.find((each) => each.name === name)?.use;
    for (const name of ['bodyBytes', 'bodyBytesOfStrangers', 'bodyBytesPerAddress']) {
      expect(use(name)?.value).toBe(600);
    }
    expect(use('bodyBytesPerClient')?.value).toBe(0);
  });
});
