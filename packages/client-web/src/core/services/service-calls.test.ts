import { ServiceError } from '@ubii/proto';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { decode, encode } from '@ubii/proto';
import { FakeClock, settle } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import { ConnectionError } from '../connection/connection-error.ts';
import { Deferred } from '../callbacks/deferred.ts';
import { ServiceCalls } from './service-calls.ts';

function setup() {
  const clock = new FakeClock();
  const sent: Init<ServiceRequest>[] = [];
  const replies: Deferred<ServiceReply>[] = [];
  let cancelled = 0;
  const calls = new ServiceCalls(
    {
      send(request) {
        sent.push(request);
        const reply = new Deferred<ServiceReply>();
        replies.push(reply);
        return { reply: reply.promise, cancel: () => (cancelled += 1) };
      },
    },
    clock,
    1_000,
  );
  const answer = (reply: Init<ServiceReply>, index = 0): void =>
    replies[index]!.resolve(
      decode('ubii.services.ServiceReply', encode('ubii.services.ServiceReply', reply)),
    );
  return { clock, calls, sent, answer, replies, cancelled: () => cancelled };
}

describe('ServiceCalls', () => {
  it('puts the request into its member and gives the payload of the reply', async () => {
    const { calls, sent, answer, clock } = setup();
    const called = calls.call('topicSubscription', { subscribeTopics: ['/a'] });
    answer({ success: { title: 'Success' } });
    expect((await called).title).toBe('Success');
    expect(sent).toEqual([
      { topic: '/services/topic_subscription', topicSubscription: { subscribeTopics: ['/a'] } },
    ]);
    expect(clock.timerCount).toBe(0);
  });

  it('leaves an optional request out', () => {
    const { calls, sent } = setup();
    void calls.call('clientGetList', undefined);
    expect(sent).toEqual([{ topic: '/services/client/get_list' }]);
  });

  it('rejects with the error the master answered', async () => {
    const { calls, answer } = setup();
    const called = calls.call('topicList', undefined);
    answer({ error: { title: 'No', message: 'Too many topics', code: 'resource_exhausted' } });
    await expect(called).rejects.toThrow(ServiceError);
    await expect(called).rejects.toMatchObject({
      code: 'resource_exhausted',
      message: 'Too many topics',
    });
  });

  it('rejects a reply of another kind', async () => {
    const { calls, answer } = setup();
    const called = calls.call('topicList', undefined);
    answer({ success: { title: 'Success' } });
    await expect(called).rejects.toMatchObject({ name: 'ConnectionError', reason: 'protocol' });
  });

  it('times out, and cancels the request', async () => {
    const { calls, clock, cancelled } = setup();
    const called = calls.call('topicList', undefined);
    const outcome = called.catch((error: unknown) => error);
    await clock.advance(999);
    expect(cancelled()).toBe(0);
    await clock.advance(1);
    expect(await outcome).toMatchObject({ name: 'ConnectionError', reason: 'timeout' });
    expect(cancelled()).toBe(1);
  });

  it('ignores what comes after the time-out', async () => {
    const { calls, clock, answer } = setup();
    const called = calls.call('topicList', undefined).catch((error: unknown) => error);
    await clock.advance(1_000);
    answer({ stringList: { elements: [] } });
    expect(await called).toBeInstanceOf(ConnectionError);
  });

  it('passes the failure of the transport on', async () => {
    const { calls, replies } = setup();
    const called = calls.call('topicList', undefined);
    replies[0]!.reject(new ConnectionError('refused', 'the master is down'));
    await expect(called).rejects.toMatchObject({ reason: 'refused' });
  });

  it('rejects every open call at once, and none that comes later', async () => {
    const { calls, answer, clock, cancelled } = setup();
    const first = calls.call('topicList', undefined).catch((error: unknown) => error);
    const second = calls.call('serviceList', undefined).catch((error: unknown) => error);
    calls.rejectAll(new ConnectionError('closed', 'The client was closed'));
    expect(await first).toMatchObject({ reason: 'closed' });
    expect(await second).toMatchObject({ reason: 'closed' });
    expect(cancelled()).toBe(2);
    expect(clock.timerCount).toBe(0);

    const third = calls.call('topicList', undefined);
    await settle();
    answer({ stringList: { elements: ['/a'] } }, 2);
    expect((await third).elements).toEqual(['/a']);
  });
});
