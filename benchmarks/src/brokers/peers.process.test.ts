import { expect, it } from 'vitest';
import { createRecordRing } from '../load/record-ring.ts';
import { measureSome } from '../measuring/some-deliveries.ts';
import { measureFanOut } from '../workloads/fan-out.ts';
import { PEERS } from '../workloads/peers.ts';

const OTHERS = Object.entries(PEERS).filter(([name]) => name !== 'nats');

// NATS: see cluster.process.test.ts
it.each(OTHERS)('%s passes on every record, unaltered', async (_name, start) => {
  const peer = await start();
  try {
    const ring = createRecordRing('fan-out');
    const fan = { subscribers: 3, window: 8 };
    const { faults, deliveries } = await measureSome((options) =>
      measureFanOut(fan, peer, ring, options),
    );
    expect(faults).toEqual([]);
    expect(deliveries).toBeGreaterThan(0);
  } finally {
    await peer.stop();
  }
});
