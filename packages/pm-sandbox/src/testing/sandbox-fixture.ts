import { decodeRecord, encodeRecord, type DataFormat, type RecordInit } from '@ubii/proto';
import type {
  Sandbox,
  SandboxCall,
  SandboxEvents,
  SandboxFactory,
  SandboxInput,
  SandboxOutput,
  SandboxRecord,
  SandboxRequest,
} from '../ports/sandbox.ts';
import type { ModuleFault } from '../ports/module-fault.ts';

/** Parts of a module that a test specifies; others have defaults. */
export interface SandboxInit {
  readonly onProcessing?: string;
  readonly onCreated?: string;
  readonly onHalted?: string;
  readonly onDestroyed?: string;
  /** Names of the declared inputs. */
  readonly inputs?: readonly string[];
  readonly outputs?: Readonly<Record<string, DataFormat | undefined>>;
  readonly libraries?: readonly string[];
  readonly assets?: SandboxRequest['assets'];
  readonly limits?: Partial<SandboxRequest['limits']>;
  readonly instanceId?: string;
  readonly isTrusted?: boolean;
  readonly owner?: string;
  readonly previousFault?: ModuleFault;
  readonly onMemory?: (bytes: number) => void;
  readonly onLoadAssets?: SandboxEvents['onLoadAssets'];
}

/** A sandbox with what it told. */
export interface OpenSandbox {
  readonly sandbox: Sandbox;
  readonly lines: string[];
  /** Resolves when the instance is killed. */
  readonly killed: Promise<ModuleFault>;
  /** Runs once. */
  run(call?: Partial<SandboxCall>): ReturnType<Sandbox['run']>;
}

let opened = 0;

/** Opens an instance. */
export function openSandbox(
  factory: SandboxFactory,
  init: SandboxInit,
  isTrusted: boolean,
): OpenSandbox {
  const lines: string[] = [];
  let kill!: (fault: ModuleFault) => void;
  const killed = new Promise<ModuleFault>((resolve) => {
    kill = resolve;
  });
  const events: SandboxEvents = {
    onLog: ({ level, text }) => lines.push(`${level}: ${text}`),
    ...(init.onMemory && { onMemory: init.onMemory }),
    ...(init.onLoadAssets && { onLoadAssets: init.onLoadAssets }),
    onKilled: kill,
  };
  const { onProcessing = '() => {}', onCreated, onHalted, onDestroyed } = init;
  const sandbox = factory.open(
    {
      instanceId: init.instanceId ?? `instance-${++opened}`,
      moduleName: 'module',
      source: { onProcessing, onCreated, onHalted, onDestroyed },
      isTrusted: init.isTrusted ?? isTrusted,
      libraries: init.libraries ?? [],
      assets: init.assets ?? [],
      inputs: init.inputs ?? [],
      owner: init.owner ?? 'owner',
      previousFault: init.previousFault,
      outputs: Object.entries<DataFormat | undefined>(init.outputs ?? { out: 'string' }).map(
        ([name, format]) => ({
          name,
          format,
        }),
      ),
      limits: {
        callTimeoutMs: 400,
        memoryBytes: 32 * 1024 * 1024,
        outputBytes: 32 * 1024 * 1024,
        ...init.limits,
      },
    },
    events,
  );
  return {
    sandbox,
    lines,
    killed,
    run: (call) => sandbox.run({ deltaTimeMs: 0, inputs: [], ...call }),
  };
}

/** An input with one record. */
export function recordInput(name: string, record: RecordInit): SandboxInput {
  return { name, record: { bytes: encodeRecord(record) } };
}

/** An input of a muxer. */
export function elementsInput(
  name: string,
  elements: readonly (RecordInit & Pick<SandboxRecord, 'identity' | 'receivedAtMs'>)[],
): SandboxInput {
  const encoded = elements.map(({ identity, receivedAtMs, ...record }): SandboxRecord => ({
    bytes: encodeRecord(record),
    identity,
    receivedAtMs,
  }));
  return { name, elements: encoded };
}

/** Outputs with their values decoded: `{ out: value }`, and arrays of elements for lists. */
export function valuesOf(outputs: readonly SandboxOutput[]): Record<string, unknown> {
  return Object.fromEntries(
    outputs.map((output) => [
      output.name,
      'value' in output
        ? decodeRecord(output.value.bytes).value
        : output.elements.map(({ value, params, identity, index }) => ({
            value: decodeRecord(value.bytes).value,
            params,
            identity,
            index,
          })),
    ]),
  );
}

/** The fault a promise rejects with. */
export async function faultFrom(promise: Promise<unknown>): Promise<ModuleFault> {
  let value: unknown;
  try {
    value = await promise;
  } catch (fault) {
    return fault as ModuleFault;
  }
  throw new Error(`expected a fault, got ${JSON.stringify(value)}`);
}
