import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { createRecordRing } from '../load/record-ring.ts';
import { measureSome } from '../measuring/some-deliveries.ts';
import { measureFanOut } from '../workloads/fan-out.ts';
import { measureLegs } from '../workloads/round-trip.ts';
import { startNatsPart, startRelays, type NatsPart } from './cluster.ts';

describe('NATS alone', () => {
  let nats: NatsPart;
  beforeAll(async () => {
    nats = await startNatsPart();
  });
  afterAll(() => nats.stop());

  it('passes everything on in a round trip of four legs', async () => {
    const legs = Array.from({ length: 4 }, (_, index) => ({
      access: nats,
      ring: createRecordRing(`leg-${index}`, 100),
    }));
    const { faults, deliveries } = await measureSome((options) =>
      measureLegs(legs, nats.pids, options),
    );
    expect(faults).toEqual([]);
    expect(deliveries).toBeGreaterThan(0);
  });

  it('passes everything on in a fan-out', async () => {
    const ring = createRecordRing('fan-out', 100);
    const fan = { subscribers: 30, window: 64 };
    const { faults, deliveries } = await measureSome((options) =>
      measureFanOut(fan, nats, ring, options),
    );
    expect(faults).toEqual([]);
    expect(deliveries).toBeGreaterThan(0);
  });

  it('passes everything on between the clients of two relays', async () => {
    const relays = await startRelays(nats, undefined);
    try {
      const legs = relays.accesses.map((access, index) => ({
        access,
        ring: createRecordRing(`relay-leg-${index}`, 100),
      }));
      const { faults, deliveries } = await measureSome((options) =>
        measureLegs(legs, relays.accesses[0]!.pids, options),
      );
      expect(faults).toEqual([]);
      expect(deliveries).toBeGreaterThan(0);
    } finally {
      await relays.stop();
    }
  });
});
