import { describe, expect, it } from 'vitest';
import type { Mapping } from '../core/mapping/mapping.ts';
import type { ForeignMessage, ForeignSystem } from '../core/ports/foreign-system.ts';
import type { Inbox } from './inbox.ts';
import { isConnected, SystemEvents } from './system-events.ts';

/** An adapter with a program at its other end. */
export interface SystemBench<P> {
  readonly system: ForeignSystem<P>;
  /** Address of the other system with this last level; `+` for any. */
  address(level: string): string;
  mapping(direction: Mapping['direction'], foreign: string): Mapping;
  payload(number: number): P;
  number(payload: P): number;
  /** The program at the other end publishes, once the adapter listens. */
  publish(address: string, number: number): void | Promise<void>;
  /** What the program at the other end has received. */
  readonly received: Inbox<{ readonly address: string; readonly number: number }>;
  /** Ends the other system, and starts it again at the same place; not for systems without a connection. */
  readonly outage?: { end(): Promise<void>; begin(): Promise<void> };
  close(): Promise<void>;
}

/** Sentences that every adapter of a system fulfils. [BR-2] */
export function foreignSystemSuite<P>(
  name: string,
  openBench: () => Promise<SystemBench<P>>,
): void {
  const withBench =
    (test: (bench: SystemBench<P>, seen: SystemEvents<P>) => Promise<void>) =>
    async (): Promise<void> => {
      const bench = await openBench();
      try {
        await test(bench, new SystemEvents());
      } finally {
        await bench.system.close();
        await bench.close();
      }
    };
  const numberOf = (bench: SystemBench<P>, { payload }: ForeignMessage<P>): number =>
    bench.number(payload);

  describe(`${name}, a ForeignSystem`, { timeout: 60_000 }, () => {
    it(
      'receives what its mappings select, and nothing else',
      withBench(async (bench, seen) => {
        bench.system.open(seen);
        bench.system.setMappings([bench.mapping('in', bench.address('+'))]);
        await seen.states.next(isConnected);
        await bench.publish(bench.address('first'), 1);
        const message = await seen.messages.next();
        expect(message.address).toBe(bench.address('first'));
        expect(numberOf(bench, message)).toBe(1);
        expect([message.isOurs, message.isEmpty]).toEqual([false, false]);
        expect(message.sizeBytes).toBeGreaterThan(0);
      }),
    );

    it(
      'sends what it is given, in order',
      withBench(async (bench, seen) => {
        const mapping = bench.mapping('out', bench.address('result'));
        bench.system.open(seen);
        bench.system.setMappings([mapping]);
        await seen.states.next(isConnected);
        for (const number of [1, 2, 3]) {
          const sent = bench.system.send({
            address: bench.address('result'),
            mapping,
            payload: bench.payload(number),
          });
          expect(sent).toEqual({ kind: 'sent' });
        }
        for (const number of [1, 2, 3]) {
          expect(await bench.received.next()).toEqual({
            address: bench.address('result'),
            number,
          });
        }
      }),
    );

    it(
      'follows other mappings while it is connected',
      withBench(async (bench, seen) => {
        bench.system.open(seen);
        bench.system.setMappings([bench.mapping('in', bench.address('old'))]);
        await seen.states.next(isConnected);
        await seen.settled.next();
        bench.system.setMappings([bench.mapping('in', bench.address('new'))]);
        await seen.settled.next();
        await bench.publish(bench.address('new'), 2);
        const message = await seen.messages.next(({ address }) => address === bench.address('new'));
        expect(numberOf(bench, message)).toBe(2);
      }),
    );

    it(
      'takes messages before it is connected, and says what becomes of them',
      withBench(async (bench, seen) => {
        const mapping = bench.mapping('out', bench.address('early'));
        const message = { address: bench.address('early'), mapping, payload: bench.payload(7) };
        const sent = bench.system.send(message);
        expect(['waiting', 'dropped']).toContain(sent.kind);
        bench.system.open(seen);
        bench.system.setMappings([mapping]);
        await seen.states.next(isConnected);
        if (sent.kind === 'waiting') expect((await bench.received.next()).number).toBe(7);
        else expect(sent).toHaveProperty('reason');
      }),
    );

    it(
      'connects again when the other system was away, with its mappings',
      withBench(async (bench, seen) => {
        if (bench.outage === undefined) return;
        bench.system.open(seen);
        bench.system.setMappings([bench.mapping('in', bench.address('+'))]);
        await seen.states.next(isConnected);
        await bench.outage.end();
        const away = await seen.states.next(({ status }) => status === 'waiting');
        expect(away).toHaveProperty('reason');
        await bench.outage.begin();
        await seen.states.next(isConnected);
        await bench.publish(bench.address('again'), 3);
        expect(numberOf(bench, await seen.messages.next())).toBe(3);
      }),
    );

    it(
      'says nothing after it was closed',
      withBench(async (bench, seen) => {
        bench.system.open(seen);
        bench.system.setMappings([bench.mapping('in', bench.address('+'))]);
        await seen.states.next(isConnected);
        await bench.system.close();
        const { count } = seen;
        await bench.publish(bench.address('late'), 4);
        const mapping = bench.mapping('out', bench.address('late'));
        const message = { address: bench.address('late'), mapping, payload: bench.payload(5) };
        expect(bench.system.send(message).kind).toBe('dropped');
        expect(seen.count).toBe(count);
      }),
    );
  });
}
