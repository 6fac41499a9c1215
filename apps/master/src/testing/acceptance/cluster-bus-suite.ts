import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { BusListener, ClusterBus } from '../../core/ports/cluster-bus.ts';
import { Inbox } from './inbox.ts';

/** A bus that several masters may join, and hands that take it away. */
export interface BusBench {
  /** A bus for this master, which does not listen yet. */
  readonly open: (masterId: string) => Promise<ClusterBus>;
  /** Takes the bus away from this master, or gives it back. */
  readonly setReachable: (masterId: string, isReachable: boolean) => Promise<void>;
  readonly close: () => Promise<void>;
}

const A = '0a7d3f0e-5a53-4d6c-9f3c-111111111111';
const B = '0a7d3f0e-5a53-4d6c-9f3c-222222222222';
const C = '0a7d3f0e-5a53-4d6c-9f3c-333333333333';
const UNKNOWN_ID = '0a7d3f0e-5a53-4d6c-9f3c-999999999999';
/** As large as a frame may be by default, and more than an engine takes at once. */
const LARGE_BYTES = 5_000_000;

/** Acceptance tests of what carries messages between masters. [CU-50] */
export function clusterBusSuite(name: string, openBench: () => Promise<BusBench>): void {
  describe(`${name}, a ClusterBus`, () => {
    let bench: BusBench;
    beforeEach(async () => {
      bench = await openBench();
    });
    afterEach(() => bench.close());

    const join = async (masterId: string): Promise<Member> => {
      const member = new Member(await bench.open(masterId));
      member.bus.listen(masterId, member);
      expect(await member.reach.next()).toBe(true);
      return member;
    };

    it('carries a message to the one it is for, and tells whose it is', async () => {
      const [a, b, c] = [await join(A), await join(B), await join(C)];
      a.bus.send(B, Uint8Array.of(1, 2, 3));
      expect(await b.messages.next()).toEqual({ from: A, bytes: [1, 2, 3] });
      b.bus.send(C, Uint8Array.of(4));
      expect(await c.messages.next()).toEqual({ from: B, bytes: [4] });
      expect(a.messages.waiting).toEqual([]);
    });

    it('carries a broadcast to every other master', async () => {
      const [a, b, c] = [await join(A), await join(B), await join(C)];
      a.bus.broadcast(Uint8Array.of(7));
      expect(await b.messages.next()).toEqual({ from: A, bytes: [7] });
      expect(await c.messages.next()).toEqual({ from: A, bytes: [7] });
      c.bus.send(A, Uint8Array.of(8));
      expect(await a.messages.next()).toEqual({ from: C, bytes: [8] });
    });

    it('keeps the order, broadcasts and large messages among them', async () => {
      const [a, b] = [await join(A), await join(B)];
      const large = new Uint8Array(LARGE_BYTES).map((_, at) => at % 251);
      const expected = large.slice();
      for (let n = 0; n < 100; n += 1) a.bus.send(B, Uint8Array.of(n));
      a.bus.send(B, large);
      a.bus.broadcast(Uint8Array.of(100));
      a.bus.send(B, Uint8Array.of(101));
      for (let n = 0; n < 100; n += 1) expect((await b.messages.next()).bytes).toEqual([n]);
      expect(Buffer.from((await b.messages.next()).bytes).equals(expected)).toBe(true);
      expect((await b.messages.next()).bytes).toEqual([100]);
      expect((await b.messages.next()).bytes).toEqual([101]);
    });

    it('carries large broadcasts, from two masters at once, and empty messages', async () => {
      const [a, b, c] = [await join(A), await join(B), await join(C)];
      a.bus.broadcast(new Uint8Array(LARGE_BYTES).fill(1));
      b.bus.broadcast(new Uint8Array(LARGE_BYTES).fill(2));
      a.bus.send(C, new Uint8Array(0));
      const got = [await c.messages.next(), await c.messages.next(), await c.messages.next()];
      const sizes = got.map(({ from, bytes }) => [from, bytes.length, bytes[0]]);
      expect(sizes).toHaveLength(3);
      expect(sizes).toContainEqual([A, LARGE_BYTES, 1]);
      expect(sizes).toContainEqual([B, LARGE_BYTES, 2]);
      expect(sizes.filter(([from]) => from === A)).toEqual([
        [A, LARGE_BYTES, 1],
        [A, 0, undefined],
      ]);
    });

    it('loses what is sent to masters that are not there, and to itself', async () => {
      const [a, b] = [await join(A), await join(B)];
      a.bus.send(UNKNOWN_ID, Uint8Array.of(1));
      a.bus.send(A, Uint8Array.of(2));
      a.bus.send(B, Uint8Array.of(3));
      expect((await b.messages.next()).bytes).toEqual([3]);
      b.bus.send(A, Uint8Array.of(4));
      expect((await a.messages.next()).bytes).toEqual([4]);
    });

    it('tells when it is away, loses what is sent meanwhile, and works again', async () => {
      const [a, b] = [await join(A), await join(B)];
      await bench.setReachable(A, false);
      expect(await a.reach.next()).toBe(false);
      a.bus.send(B, Uint8Array.of(1));
      a.bus.broadcast(Uint8Array.of(2));
      await bench.setReachable(A, true);
      expect(await a.reach.next()).toBe(true);
      a.bus.send(B, Uint8Array.of(3));
      expect((await b.messages.next()).bytes).toEqual([3]);
    });

    it('brings what was sent before it was closed, and nothing after', async () => {
      const [a, b] = [await join(A), await join(B)];
      a.bus.send(B, new Uint8Array(LARGE_BYTES).fill(9));
      a.bus.broadcast(Uint8Array.of(1));
      await a.bus.close();
      a.bus.send(B, Uint8Array.of(2));
      a.bus.broadcast(Uint8Array.of(3));
      const c = await join(C);
      c.bus.send(B, Uint8Array.of(4));
      expect((await b.messages.next()).bytes).toHaveLength(LARGE_BYTES);
      expect((await b.messages.next()).bytes).toEqual([1]);
      expect((await b.messages.next()).bytes).toEqual([4]);
      expect(b.messages.waiting).toEqual([]);
      await a.bus.close();
    });

    it('has nothing queued when all has arrived', async () => {
      const [a, b] = [await join(A), await join(B)];
      a.bus.send(B, new Uint8Array(LARGE_BYTES));
      await b.messages.next();
      expect(a.bus.queuedBytes).toBe(0);
    });
  });
}

class Member implements BusListener {
  readonly bus: ClusterBus;
  readonly messages = new Inbox<{ from: string; bytes: number[] | Uint8Array }>();
  readonly reach = new Inbox<boolean>();

  constructor(bus: ClusterBus) {
    this.bus = bus;
  }

  handleMessage(from: string, message: Uint8Array): void {
    const bytes = message.byteLength > 1000 ? message : [...message];
    this.messages.add({ from, bytes });
  }

  handleReach(isReachable: boolean): void {
    this.reach.add(isReachable);
  }
}
