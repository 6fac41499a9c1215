import { setTimeout as sleep } from 'node:timers/promises';
import { brokerSubjects } from '../brokers/brokers.ts';
import { REFERENCE, type Access } from '../brokers/target.ts';
import { startLap } from '../measuring/stopwatch.ts';
import type { Measurement, MeasureOptions, Workload } from '../measuring/workload.ts';
import { PartyTraffic } from '../party/party-traffic.ts';
import { percentile } from '../statistics.ts';

const OURS = 'ubii-extension';

/** What a party asks of a broker, without its game. */
export const partyTraffic: Workload = {
  name: 'party-traffic',
  group: 'party-traffic',
  title: 'Party: 64 inputs at 60 Hz to one pattern subscriber, 2 KB at 60 Hz to 64',
  figures: [
    {
      key: 'cpu',
      label: 'broker CPU',
      unit: 'cores',
      isHigherBetter: false,
      goals: { [OURS]: 1.25 },
    },
    { key: 'p50Ms', label: 'state p50', unit: 'ms', isHigherBetter: false, goals: {} },
    {
      key: 'p99Ms',
      label: 'state p99',
      unit: 'ms',
      isHigherBetter: false,
      goals: { [OURS]: 1.3 },
    },
  ],
  placement: 'core-each',
  reference: REFERENCE,
  roundShare: 1,
  open: (setting) => brokerSubjects(setting, measureTraffic),
};

async function measureTraffic(
  access: Access,
  { warmUpMs, measureMs }: MeasureOptions,
): Promise<Measurement> {
  const traffic = await PartyTraffic.open(access);
  traffic.play();
  await sleep(500 + warmUpMs);
  const stopLap = startLap(access.pids);
  traffic.sample();
  await sleep(measureMs);
  const lap = stopLap();
  const { sorted, faults, records } = await traffic.end();
  return {
    figures: {
      cpu: lap.cpuUs / lap.wallUs,
      p50Ms: percentile(sorted, 0.5),
      p99Ms: percentile(sorted, 0.99),
    },
    otherCpuShare: lap.otherCpuShare,
    deliveries: records,
    faults,
  };
}
