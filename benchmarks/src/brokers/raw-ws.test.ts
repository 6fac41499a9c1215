import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { WORKLOADS } from '../workloads/index.ts';
import { startRawWs } from './raw-ws.ts';
import type { Broker } from './target.ts';

describe('the raw-ws broker', () => {
  let broker: Broker;
  beforeAll(async () => {
    broker = await startRawWs(undefined);
  });
  afterAll(() => broker.stop());

  it.each(WORKLOADS.map((workload) => [workload.name, workload] as const))(
    'passes everything on in %s',
    async (_name, workload) => {
      const options = { warmUpMs: 10, measureMs: 50 };
      const [target] = broker.targets;
      const measurement = await workload.measure(target!, workload.createRing(), options);
      expect(measurement.faults).toEqual([]);
      expect(measurement.deliveries).toBeGreaterThan(0);
    },
  );
});
