import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { ServiceError } from '@ubii/proto';
import { afterEach, describe, expect, it } from 'vitest';
import type { ServiceTransport } from '../core/ports/service-transport.ts';

/** Answers one request; a rejection means that the master breaks down over it. */
export type AnswerRequest = (request: ServiceRequest) => Promise<Init<ServiceReply>>;

/** A transport with a master behind it that does what the suite says. */
export interface ServiceTransportWorld {
  readonly transport: ServiceTransport;
  /** Makes the master unreachable and frees what the world holds. */
  close(): Promise<void>;
}

/**
 * Acceptance tests of service transports. An adapter's test passes a function that sets up the adapter and a master at
 * its other end.
 */
export function describeServiceTransport(
  name: string,
  setup: (answer: AnswerRequest) => Promise<ServiceTransportWorld>,
): void {
  describe(`${name} as a service transport`, () => {
    let world: ServiceTransportWorld | undefined;
    const open = async (answer: AnswerRequest): Promise<ServiceTransport> => {
      world = await setup(answer);
      return world.transport;
    };
    afterEach(async () => {
      await world?.close();
      world = undefined;
    });

    it('carries a request there and its reply back', async () => {
      const received: ServiceRequest[] = [];
      const transport = await open((request) => {
        received.push(request);
        return Promise.resolve({ client: { id: 'c1', name: 'Ada Łovelace ☂' } });
      });
      const { reply } = transport.send({
        topic: '/services/client/registration',
        client: { name: 'Ada Łovelace ☂', tags: ['a', ''], extension: { recordLists: true } },
      });
      expect((await reply).client).toMatchObject({ id: 'c1', name: 'Ada Łovelace ☂' });
      expect(received).toMatchObject([
        {
          topic: '/services/client/registration',
          client: { name: 'Ada Łovelace ☂', tags: ['a', ''], extension: { recordLists: true } },
        },
      ]);
    });

    it('resolves with an error reply as with any other', async () => {
      const transport = await open(() =>
        Promise.resolve({ error: new ServiceError('not_found', 'No such client').toWire() }),
      );
      const { error } = await transport.send({ topic: '/services/topic_list' }).reply;
      expect(error).toMatchObject({ code: 'not_found', message: 'No such client' });
    });

    it('carries large requests and replies', async () => {
      const topics = Array.from({ length: 20_000 }, (_, i) => `/a/rather/long/topic/${i}`);
      const transport = await open((request) =>
        Promise.resolve({ stringList: { elements: request.topicSubscription!.subscribeTopics } }),
      );
      const { reply } = transport.send({
        topic: '/services/topic_subscription',
        topicSubscription: { subscribeTopics: topics },
      });
      expect((await reply).stringList?.elements).toEqual(topics);
    });

    it('keeps requests apart', async () => {
      const waiting = new Map<string, () => void>();
      const transport = await open(
        (request) =>
          new Promise((resolve) => {
            const { name } = request.client!;
            waiting.set(name, () => resolve({ client: { name } }));
            if (waiting.size === 3) for (const answer of [...waiting.values()].reverse()) answer();
          }),
      );
      const replies = await Promise.all(
        ['ada', 'ben', 'cleo'].map(
          (client) => transport.send({ topic: '/t', client: { name: client } }).reply,
        ),
      );
      expect(replies.map(({ client }) => client?.name)).toEqual(['ada', 'ben', 'cleo']);
    });

    it('rejects when the master breaks down', async () => {
      const transport = await open(() => Promise.reject(new Error('broken')));
      await expect(transport.send({ topic: '/t' }).reply).rejects.toMatchObject({
        name: 'ConnectionError',
        reason: 'refused',
      });
    });

    it('rejects when there is no master', async () => {
      const transport = await open(() => Promise.resolve({ success: {} }));
      await world?.close();
      await expect(transport.send({ topic: '/t' }).reply).rejects.toMatchObject({
        name: 'ConnectionError',
        reason: 'refused',
      });
    });

    it('rejects at once when cancelled, and settles once', async () => {
      let arrived = (): void => undefined;
      const hasArrived = new Promise<void>((resolve) => (arrived = resolve));
      const transport = await open(() => {
        arrived();
        return new Promise(() => undefined);
      });
      const exchange = transport.send({ topic: '/t' });
      const outcome = exchange.reply.catch((error: unknown) => error);
      await hasArrived;
      exchange.cancel();
      exchange.cancel();
      expect(await outcome).toMatchObject({ name: 'ConnectionError', reason: 'closed' });
    });
  });
}
