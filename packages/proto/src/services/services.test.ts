import { describe, expect, expectTypeOf, it } from 'vitest';
import { isMessageType } from '../codec.ts';
import type {
  Client,
  ClientList,
  Server,
  Success,
  TopicStatistics,
  TopicStatisticsRequest,
  TopicSubscription,
} from '../generated/messages.ts';
import { PUBLISHED_CONSTANTS } from '../testing/published-formats.ts';
import {
  serviceByTopic,
  SERVICES,
  type ServiceName,
  type ServiceReplyOf,
  type ServiceRequestOf,
} from './services.ts';

const NAMES = Object.keys(SERVICES) as ServiceName[];
const INFOS = Object.values(SERVICES);

describe('the service table', () => {
  it('has every topic of the published constants, and ours by the names of the services', () => {
    const topics: string[] = INFOS.filter(({ isExtension }) => !isExtension).map(
      ({ topic }) => topic,
    );
    expect(topics.sort()).toEqual(
      Object.values(PUBLISHED_CONSTANTS.DEFAULT_TOPICS.SERVICES).sort(),
    );
    const ours = NAMES.filter((name) => SERVICES[name].isExtension);
    for (const name of ours) {
      const words = name.replace(/[A-Z]/g, (letter) => `_${letter.toLowerCase()}`);
      expect(SERVICES[name].topic).toBe(`/services/ubii/${words}`);
    }
  });

  it('[EX-21] lists nodes without a payload, and holds a session by what starts one', () => {
    const { sessionRuntimeStart, sessionPause, sessionResume, nodeList } = SERVICES;
    expect(nodeList).toMatchObject({ request: undefined, reply: 'nodeList' });
    for (const service of [sessionPause, sessionResume]) {
      expect(service).toMatchObject({
        request: sessionRuntimeStart.request,
        requestRequired: true,
        reply: 'session',
      });
    }
  });

  it('[SV-9] has every topic once', () => {
    expect(new Set(INFOS.map(({ topic }) => topic)).size).toBe(INFOS.length);
  });

  it.each(NAMES)('%s: formats are messages, description is a sentence', (name) => {
    const { request, requestRequired, requestFormat, replyFormat, description } = SERVICES[name];
    expect(isMessageType(replyFormat)).toBe(true);
    expect(request === undefined ? requestFormat === '' : isMessageType(requestFormat)).toBe(true);
    expect(requestRequired && request === undefined).toBe(false);
    expect(description).toMatch(/^[A-Z][^.]*\.$/);
  });

  it('is found by topic', () => {
    for (const name of NAMES) expect(serviceByTopic(SERVICES[name].topic)).toBe(name);
    expect(serviceByTopic('/services/nothing')).toBeUndefined();
  });

  it('derives the formats from the members', () => {
    expect(SERVICES.topicSubscription).toMatchObject({
      topic: '/services/topic_subscription',
      request: 'topicSubscription',
      requestFormat: 'ubii.services.request.TopicSubscription',
      reply: 'success',
      replyFormat: 'ubii.general.Success',
      requestRequired: true,
    });
  });

  it('types requests and replies', () => {
    expectTypeOf<ServiceRequestOf<'topicSubscription'>>().toEqualTypeOf<TopicSubscription>();
    expectTypeOf<ServiceReplyOf<'topicSubscription'>>().toEqualTypeOf<Success>();
    expectTypeOf<ServiceRequestOf<'serverConfiguration'>>().toEqualTypeOf<undefined>();
    expectTypeOf<ServiceReplyOf<'serverConfiguration'>>().toEqualTypeOf<Server>();
    expectTypeOf<ServiceRequestOf<'clientGetList'>>().toEqualTypeOf<ClientList>();
    expectTypeOf<ServiceReplyOf<'clientRegistration'>>().toEqualTypeOf<Client>();
    expectTypeOf<ServiceRequestOf<'topicStatistics'>>().toEqualTypeOf<TopicStatisticsRequest>();
    expectTypeOf<ServiceReplyOf<'topicStatistics'>>().toEqualTypeOf<TopicStatistics>();
    expectTypeOf(SERVICES.clientGetList.requestRequired).toEqualTypeOf<false>();
    expectTypeOf(SERVICES.clientRegistration.requestRequired).toEqualTypeOf<true>();
  });
});
