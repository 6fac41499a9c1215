import type { Callee } from '../calls/call-series.ts';
import { measureCalls, warmUp } from '../calls/measure-calls.ts';
import { bareCallee, moduleCallee, openModule } from '../calls/module-callee.ts';
import { picturePayload, RECORD_PAYLOAD, type Payload } from '../calls/payload.ts';
import { startBareWorker, startNodeSandboxes } from '../modules/node-sandboxes.ts';
import type { FigureInfo, Subject, Workload } from '../measuring/workload.ts';

const REFERENCE = 'bare worker';

/** Figures of calls. */
const CALL_FIGURES: readonly FigureInfo[] = [
  { key: 'p50Us', label: 'p50', unit: 'µs', isHigherBetter: false, goals: {} },
  { key: 'p99Us', label: 'p99', unit: 'µs', isHigherBetter: false, goals: {} },
  {
    key: 'callingCpuUs',
    label: 'CPU a call, calling thread',
    unit: 'µs',
    isHigherBetter: false,
    goals: {},
  },
  {
    key: 'ownCpuUs',
    label: 'CPU a call, all threads',
    unit: 'µs',
    isHigherBetter: false,
    goals: {},
  },
];

/** One call of a module in Node, trusted and sandboxed, beside a message to a worker and back. */
export function moduleCall(name: string, createPayload: () => Payload): Workload {
  const { title } = createPayload();
  return {
    name: `module-call-${name}`,
    group: 'module-call',
    title: `Call of a module in Node: ${title}`,
    figures: CALL_FIGURES,
    reference: REFERENCE,
    // Only one thread has work at a time, as in the round trip.
    placement: 'one-core',
    roundShare: 1 / 3,
    open: async ({ parts }) => {
      const payload = createPayload();
      const bare = await parts.get('bare worker', startBareWorker);
      const { sandboxes } = await parts.get('sandboxes', startNodeSandboxes);
      const trusted = await openModule(sandboxes, payload, `${name} trusted`, true);
      const sandboxed = await openModule(sandboxes, payload, `${name} sandboxed`, false);
      return [
        await subject(REFERENCE, bareCallee(bare, payload)),
        await subject('trusted', moduleCallee(trusted, payload)),
        await subject('sandboxed', moduleCallee(sandboxed, payload)),
      ];
    },
  };
}

/** Both payloads. */
export const MODULE_CALLS: readonly Workload[] = [
  moduleCall('record', () => RECORD_PAYLOAD),
  moduleCall('picture', picturePayload),
];

async function subject<P, A>(name: string, callee: Callee<P, A>): Promise<Subject> {
  await warmUp(callee);
  return { name, pids: [], measure: (options) => measureCalls(callee, options) };
}
