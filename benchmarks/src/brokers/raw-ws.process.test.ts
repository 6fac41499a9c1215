import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { createPictureRing, createRecordRing } from '../load/record-ring.ts';
import { measureSome } from '../measuring/some-deliveries.ts';
import { measureFanOut } from '../workloads/fan-out.ts';
import { measurePaced } from '../workloads/paced-pictures.ts';
import { measureRoundTrip } from '../workloads/round-trip.ts';
import { startRawWs } from './brokers.ts';
import type { Broker } from './target.ts';

describe('the raw-ws broker', () => {
  let broker: Broker;
  beforeAll(async () => {
    broker = await startRawWs(undefined);
  });
  afterAll(() => broker.stop());

  it('passes everything on in a round trip', async () => {
    const ring = createRecordRing('round-trip', 100);
    const { faults, deliveries } = await measureSome((options) =>
      measureRoundTrip(broker.targets[0]!, ring, options),
    );
    expect(faults).toEqual([]);
    expect(deliveries).toBeGreaterThan(0);
  });

  it.each([1, 64])('passes everything on in a fan-out with window %i', async (window) => {
    const ring = createRecordRing('fan-out', 100);
    const fan = { subscribers: 100, window };
    const { faults, deliveries } = await measureSome((options) =>
      measureFanOut(fan, broker.targets[0]!, ring, options),
    );
    expect(faults).toEqual([]);
    expect(deliveries).toBeGreaterThan(0);
  });

  it('passes pictures on', async () => {
    const ring = createPictureRing('pictures', 100_000, 16);
    const fan = { subscribers: 3, window: 4 };
    const { faults, deliveries } = await measureSome((options) =>
      measureFanOut(fan, broker.targets[0]!, ring, options),
    );
    expect(faults).toEqual([]);
    expect(deliveries).toBeGreaterThan(0);
  });
  it('passes pictures on at their pace', async () => {
    const ring = createPictureRing('paced-pictures', 100_000, 30);
    const { faults, deliveries } = await measureSome((options) =>
      measurePaced(broker.targets[0]!, ring, options),
    );
    expect(faults).toEqual([]);
    expect(deliveries).toBeGreaterThan(0);
  });
});
