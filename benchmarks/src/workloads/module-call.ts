import { DEFAULT_RUNTIME_LIMITS, type Sandbox, type SandboxFactory } from '@ubii/pm-sandbox';
import { startBareWorker, type BareWorker } from '../modules/bare-worker.ts';
import { startNodeSandboxes } from '../modules/node-sandboxes.ts';
import { picturePayload, RECORD_PAYLOAD, type Payload } from '../modules/payload.ts';
import { measureCalls, type Callee } from './call-loop.ts';
import type { FigureInfo, Subject, Workload } from './workload.ts';

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
        subject(REFERENCE, bareCallee(bare, payload)),
        subject('trusted', moduleCallee(trusted, payload)),
        subject('sandboxed', moduleCallee(sandboxed, payload)),
      ];
    },
  };
}

/** Both payloads. */
export const MODULE_CALLS: readonly Workload[] = [
  moduleCall('record', () => RECORD_PAYLOAD),
  moduleCall('picture', picturePayload),
];

function subject<P, A>(name: string, callee: Callee<P, A>): Subject {
  return { name, pids: [], measure: (options) => measureCalls(callee, options) };
}

async function openModule(
  sandboxes: SandboxFactory,
  payload: Payload,
  instanceId: string,
  isTrusted: boolean,
): Promise<Sandbox> {
  const { callTimeoutMs, memoryBytes, outputBytes } = DEFAULT_RUNTIME_LIMITS;
  const sandbox = sandboxes.open(
    {
      instanceId,
      moduleName: instanceId,
      source: { onProcessing: payload.onProcessing },
      isTrusted,
      libraries: [],
      outputs: [{ name: 'out', format: payload.outputFormat }],
      limits: { callTimeoutMs, memoryBytes, outputBytes },
    },
    {
      onLog: () => undefined,
      // The call that is under way rejects with the same fault, and ends the run.
      onKilled: () => undefined,
    },
  );
  await sandbox.create();
  return sandbox;
}

function moduleCallee(sandbox: Sandbox, payload: Payload): Callee<Uint8Array, Uint8Array> {
  return {
    sequence: 0,
    prepare: (sequence) => payload.record(sequence),
    call: async (bytes) => {
      const inputs = [{ name: 'in', record: { bytes, isOwned: true } }];
      const { outputs, faults } = await sandbox.run({ deltaTimeMs: 1, inputs });
      const [output] = outputs;
      if (output === undefined || !('value' in output)) {
        throw new Error(`The module put nothing out: ${JSON.stringify(faults)}`);
      }
      return output.value.bytes;
    },
    isRight: (bytes, sequence) => payload.isOutput(bytes, sequence),
  };
}

/** Calls of a bare worker. */
export function bareCallee(
  bare: BareWorker,
  payload: Payload,
): Callee<ReturnType<Payload['bareMessage']>, unknown> {
  return {
    sequence: 0,
    prepare: (sequence) => payload.bareMessage(payload.record(sequence)),
    call: ({ message, transfer }) => bare.call(message, transfer),
    isRight: (answer, sequence) => payload.isBareAnswer(answer, sequence),
  };
}
