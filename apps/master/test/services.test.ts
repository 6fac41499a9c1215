import { Re2Patterns } from '@ubii/patterns/re2';
import { DecodeError, LEGACY_CONSTANTS, ServiceError, SERVICES, toJson } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TRUSTED_CALLER, DEFAULT_LIMITS } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';

describe('services', () => {
  it('that take too long are answered with deadline_exceeded [SV-2] [EC-24]', async () => {
    // Every subscription takes longer than a turn may, and no turn ever comes.
    const master = new TestMaster({
      patterns: {
        compile(source) {
          master.clock.spend(10);
          return new Re2Patterns().compile(source);
        },
      },
    });
    const ada = await master.legacy('ada');
    const answer = master.master.handleServiceRequest(
      {
        topic: '/services/topic_subscription',
        topicSubscription: {
          clientId: ada.id,
          subscribeTopics: [],
          unsubscribeTopics: [],
          subscribeTopicRegexp: ['(a)', '(b)'],
          unsubscribeTopicRegexp: [],
          subscribeComponents: [],
          unsubscribeComponents: [],
          maxRateHz: 0,
        },
      },
      TRUSTED_CALLER,
    );
    master.clock.spend(DEFAULT_LIMITS.serviceTimeoutMs);
    master.clock.advanceSync(0);
    const { reply } = await answer;
    expect(reply.error).toMatchObject({ code: 'deadline_exceeded' });
    expect(reply.error?.message).toContain('/services/topic_subscription');
  });

  it('answer without leaving a timer behind [SV-2]', async () => {
    const master = new TestMaster();
    const before = master.clock.timerCount;
    await master.call({ topic: '/services/topic_list' });
    await master.call({ topic: '/services/unknown' });
    expect(master.clock.timerCount).toBe(before);
  });

  it('give long work turns in between, so that others are heard [SV-2]', async () => {
    const master = new TestMaster({
      patterns: {
        compile(source) {
          master.clock.spend(10);
          return new Re2Patterns().compile(source);
        },
      },
    });
    const ada = await master.legacy('ada');
    const ben = await master.legacy('ben');
    const order: string[] = [];
    const sources = Array.from({ length: 20 }, (_, i) => `(${i})`);
    const long = ada.subscribe({ subscribeTopicRegexp: sources }).then(() => order.push('long'));
    const short = ben.subscribe({ subscribeTopics: ['/a'] }).then(() => order.push('short'));
    await Promise.all([long, short]);
    expect(order).toEqual(['short', 'long']);
  });

  it('answer errors with a title, one sentence, a code and no stack [SV-5] [EX-9]', async () => {
    const master = new TestMaster();
    const { error } = await master.call({ topic: '/services/unknown' });
    expect(error).toEqual({
      title: expect.stringMatching(/\w/),
      message: expect.stringMatching(/^[A-Z].*\.$/),
      stack: '',
      code: 'unimplemented',
      problems: [],
    });
  });

  it('give nothing of an error that is ours away, but log it [SV-5]', async () => {
    const master = new TestMaster({
      endpoints: Object.defineProperty({}, 'ipWlan', {
        enumerable: true,
        get: () => {
          throw new TypeError('secret path');
        },
      }),
    });
    const { error } = await master.call({ topic: '/services/server_configuration' });
    expect(error).toMatchObject({ code: 'internal', stack: '' });
    expect(JSON.stringify(error)).not.toContain('secret');
    expect(master.log.lines).toContainEqual(
      expect.objectContaining({
        level: 'error',
        fields: expect.objectContaining({ reason: 'TypeError: secret path' }),
      }),
    );
  });

  it.each([
    ['', 'invalid_argument', 'topic'],
    ['/services/unknown', 'unimplemented', '"/services/unknown"'],
    ['services/topic_list', 'unimplemented', '"services/topic_list"'],
    ['/services/notify_condition/add', 'unimplemented', '/services/notify_condition/add'],
    ['x'.repeat(100_000), 'unimplemented', 'xxx'],
    ['__proto__', 'unimplemented', '__proto__'],
    ['constructor', 'unimplemented', 'constructor'],
  ])('answer the topic %.20j with %s, and say so [SV-6]', async (topic, code, text) => {
    const master = new TestMaster();
    const { error } = await master.call({ topic });
    expect(error).toMatchObject({ code });
    expect(error?.message).toContain(text);
    expect(error!.message.length).toBeLessThan(1000);
  });

  it.each(
    Object.values(SERVICES)
      .filter((service) => service.requestRequired)
      .map((service) => [service.topic, service.request as string]),
  )('%s without its payload names %s [SV-6]', async (topic, member) => {
    const master = new TestMaster();
    const { serviceList } = await master.call({ topic: '/services/service_list' });
    const isAnswered = serviceList!.elements.some((service) => service.topic === topic);
    for (const request of [{ topic }, { topic, clientList: {} }]) {
      const { error } = await master.call(request);
      if (isAnswered) {
        expect(error).toMatchObject({ code: 'invalid_argument' });
        expect(error?.message).toContain(member);
      } else expect(error).toMatchObject({ code: 'unimplemented' });
    }
  });

  it('answer what cannot be decoded with invalid_argument, and count it [SV-7]', async () => {
    const master = new TestMaster();
    const cause = new DecodeError('ubii.services.ServiceRequest', 3, 'it ends too early');
    const { reply, afterReply } = master.master.refuseServiceRequest(cause);
    afterReply();
    expect(reply.error).toMatchObject({ code: 'invalid_argument', stack: '' });
    expect(reply.error?.message).toContain('it ends too early');
    const late = master.master.refuseServiceRequest(new ServiceError('unavailable', 'Later.'));
    expect(late.reply.error).toMatchObject({ code: 'unavailable', message: 'Later.' });
    expect(
      master.master.metrics().find(({ name }) => name === 'ubii_service_requests_failed_total'),
    ).toMatchObject({ values: [{ value: 2 }] });
  });

  it('are listed once each, those that are answered [SV-9]', async () => {
    const master = new TestMaster();
    const { serviceList } = await master.call({ topic: '/services/service_list' });
    const topics = serviceList!.elements.map(({ topic }) => topic);
    expect(new Set(topics).size).toBe(topics.length);
    for (const service of serviceList!.elements) {
      const { error } = await master.call({ topic: service.topic });
      expect(error?.code).not.toBe('unimplemented');
      expect(service.responseMessageFormat).toMatch(/^ubii\./);
      expect(service.description).not.toBe('');
    }
    for (const { topic } of Object.values(SERVICES)) {
      if (topics.includes(topic)) continue;
      expect((await master.call({ topic })).error).toMatchObject({ code: 'unimplemented' });
    }
    expect(topics).toEqual(
      expect.arrayContaining([
        '/services/topic_subscription',
        '/services/server_configuration',
        '/services/topic_list',
        '/services/service_list',
        '/services/client/registration',
        '/services/client/deregistration',
        '/services/client/get_list',
        '/services/device/registration',
        '/services/device/deregistration',
        '/services/device/get',
        '/services/device/get_list',
        '/services/component/get_list',
        '/services/latency_clients_list',
        '/services/ubii/topic_statistics',
        '/services/ubii/master_status',
      ]),
    );
  });

  it('describe the master as existing clients need it [SV-10] [EC-3] [EC-13] [EC-14]', async () => {
    const master = new TestMaster();
    const { server } = await master.call({ topic: '/services/server_configuration' });
    expect(server).toMatchObject({
      id: master.master.id,
      name: 'master-node',
      ipEthernet: '',
      ipWlan: '',
      portServiceRest: '8102',
      portTopicDataWs: '8104',
      externalAddressServiceHttpJson: '',
    });
    for (const port of [server!.portServiceZmq, server!.portTopicDataZmq]) {
      expect(port).toMatch(/^\d+$/);
    }
    expect(JSON.parse(server!.constantsJson)).toEqual(JSON.parse(JSON.stringify(LEGACY_CONSTANTS)));
    const json = toJson('ubii.services.ServiceReply', { server: server! });
    expect(json).toMatchObject({ server: { ipWlan: '', ipEthernet: '' } });
  });

  it('give the addresses of a master in a network [SV-10] [EC-14]', async () => {
    const master = new TestMaster({ endpoints: { ipWlan: '192.168.1.7' } });
    const { server } = await master.call({ topic: '/services/server_configuration' });
    expect(server).toMatchObject({
      ipWlan: '192.168.1.7',
      externalAddressServiceHttpJson: '192.168.1.7:8102/services/json',
      externalAddressServiceHttpBinary: '192.168.1.7:8102/services/binary',
      externalAddressTopicDataWs: '192.168.1.7:8104',
    });
  });

  it('list the topics of services, and then those with a value [SV-11]', async () => {
    const master = new TestMaster();
    const ada = await master.extension('ada', { devices: [{ name: 'pen' }] });
    await ada.subscribe({ subscribeTopics: ['/no/value'] });
    ada.publish('/a', 'double', 1);
    const { stringList } = await master.call({ topic: '/services/topic_list' });
    const { serviceList } = await master.call({ topic: '/services/service_list' });
    expect(stringList?.elements).toEqual([
      ...serviceList!.elements.map(({ topic }) => topic),
      '/info/device/new',
      '/a',
    ]);
  });

  it('subscribe before they unsubscribe: topics, patterns, components [SV-12]', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada', { devices: [{ components: [{ topic: '/c' }] }] });
    await ada.subscribe({
      unsubscribeTopics: ['/a'],
      unsubscribeTopicRegexp: ['^/b'],
      unsubscribeComponents: [{}],
      subscribeTopics: ['/a', '/d'],
      subscribeTopicRegexp: ['^/b', '^/e'],
      subscribeComponents: [{}],
    });
    for (const topic of ['/a', '/b', '/c', '/d', '/e']) ada.publish(topic, 'bool', true);
    expect(ada.takeValues().map(([topic]) => topic)).toEqual(['/d', '/e']);
  });

  it('keep what was subscribed before something was refused [SV-12]', async () => {
    const master = new TestMaster();
    const ada = await master.legacy('ada');
    ada.publish('/a', 'double', 1);
    await expect(
      ada.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['(', '^/b'] }),
    ).rejects.toThrow('invalid_argument');
    master.clock.advanceSync(25);
    ada.publish('/b', 'double', 2);
    expect(ada.takeValues()).toEqual([['/a', 1]]);
  });

  it('subscribe registered clients only [SV-12]', async () => {
    const master = new TestMaster();
    for (const [clientId, code] of [
      ['', 'invalid_argument'],
      ['unknown', 'not_found'],
    ]) {
      const { error } = await master.call({
        topic: '/services/topic_subscription',
        topicSubscription: { clientId: clientId!, unsubscribeTopics: ['/a'] },
      });
      expect(error).toMatchObject({ code });
    }
  });
});
