import { brokerSubjects } from '../brokers/brokers.ts';
import { PEERS } from '../brokers/peers.ts';
import type { Access } from '../brokers/target.ts';
import { createRecordRing } from '../load/record-ring.ts';
import type { Measurement, MeasureOptions, Workload } from '../measuring/workload.ts';
import { connecting, measureConnecting } from './connections.ts';
import {
  FAN_OUT_1,
  FAN_OUT_64,
  FAN_OUT_PICTURES,
  fanOutWorkload,
  measureFanOut,
} from './fan-out.ts';
import { measureRoundTrip, roundTrip } from './round-trip.ts';

/** Clients of ours that are not those of today: they are in the workloads without peers. */
const LEGACY = 'ubii-legacy';

type Measure = (access: Access, options: MeasureOptions) => Promise<Measurement>;

/** The same workloads, with the brokers that people would use instead. */
export const PEER_WORKLOADS: readonly Workload[] = [
  withPeers(roundTrip, () => {
    const ring = createRecordRing('round-trip');
    return (access, options) => measureRoundTrip(access, ring, options);
  }),
  ...[FAN_OUT_64, FAN_OUT_1, FAN_OUT_PICTURES].map((fan) =>
    withPeers(fanOutWorkload(fan, {}), () => {
      const ring = fan.createRing();
      return (access, options) => measureFanOut(fan, access, ring, options);
    }),
  ),
  withPeers(connecting, () => measureConnecting),
];

function withPeers(workload: Workload, prepare: () => Measure): Workload {
  return {
    ...workload,
    name: `peers-${workload.name}`,
    group: 'peers',
    figures: workload.figures.map((figure) => ({ ...figure, goals: {} })),
    roundShare: 1 / 3,
    open: async (setting) => {
      const measure = prepare();
      const ours = await brokerSubjects(setting, measure);
      const theirs = Object.entries(PEERS).map(async ([name, start]) => {
        const peer = await setting.parts.get(name, () => start(setting.profileDir));
        return {
          ...{ name, pids: peer.pids },
          measure: (options: MeasureOptions) => measure(peer, options),
        };
      });
      return [...ours.filter(({ name }) => name !== LEGACY), ...(await Promise.all(theirs))];
    },
  };
}
