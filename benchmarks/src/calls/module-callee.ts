import { DEFAULT_RUNTIME_LIMITS, type Sandbox, type SandboxFactory } from '@ubii/pm-sandbox';
import type { Callee } from './call-series.ts';
import type { Payload } from './payload.ts';

/** A module with the input `in` and the output `out`, created. */
export async function openModule(
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
      assets: [],
      owner: '',
      inputs: ['in'],
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

/** Calls of a module. */
export function moduleCallee(sandbox: Sandbox, payload: Payload): Callee<Uint8Array, Uint8Array> {
  return {
    sequence: 0,
    prepare: (sequence) => payload.record(sequence),
    call: async (bytes) => {
      const inputs = [{ name: 'in', record: { bytes, isOwned: true } }];
      const { outputs, faults } = await sandbox.run({ deltaTimeMs: 1, inputs });
      const [output] = outputs;
      if (output === undefined || !('value' in output)) {
        throw new Error(`The module published nothing: ${JSON.stringify(faults)}`);
      }
      return output.value.bytes;
    },
    isRight: (bytes, sequence) => payload.isOutput(bytes, sequence),
  };
}

/** A worker that answers one message at a time. */
export interface BareCalls {
  call(message: unknown, transfer: readonly ArrayBuffer[]): Promise<unknown>;
}

/** Calls of a bare worker. */
export function bareCallee(
  bare: BareCalls,
  payload: Payload,
): Callee<ReturnType<Payload['bareMessage']>, unknown> {
  return {
    sequence: 0,
    prepare: (sequence) => payload.bareMessage(payload.record(sequence)),
    call: ({ message, transfer }) => bare.call(message, transfer),
    isRight: (answer, sequence) => payload.isBareAnswer(answer, sequence),
  };
}
