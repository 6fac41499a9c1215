import type { DataFormat } from '@ubii/proto';
import type { LoadedAssets } from '../assets/asset-store.ts';
import type { ModuleFault } from './module-fault.ts';

/** Source text of the callbacks: each evaluates, as an expression, to a function. [PM-2] */
export interface ModuleSource {
  readonly onCreated?: string | undefined;
  readonly onProcessing: string;
  readonly onHalted?: string | undefined;
  readonly onDestroyed?: string | undefined;
}

/** Limits of one instance. */
export interface SandboxLimits {
  /** A call that takes longer ends the instance, milliseconds. [PM-53] */
  readonly callTimeoutMs: number;
  /** Memory of the instance, bytes. [PM-52] */
  readonly memoryBytes: number;
  /** Bytes of all outputs of one run. */
  readonly outputBytes: number;
}

/** Description of the instance to run. */
export interface SandboxRequest {
  readonly instanceId: string;
  readonly moduleName: string;
  readonly source: ModuleSource;
  /** True: the operator vouches for the code, so it runs at full speed and with libraries. [PM-51] */
  readonly isTrusted: boolean;
  /** Names of the libraries it gets in `state.modules`. [PM-4] */
  readonly libraries: readonly string[];
  /** Asset sets it gets in `state.assets` and, those that are libraries, in `state.modules`. [PM-90] */
  readonly assets: readonly LoadedAssets[];
  /** Names of its declared inputs, for messages. */
  readonly inputs: readonly string[];
  /** Its outputs; a format that is not known takes the one member the module set. */
  readonly outputs: readonly { readonly name: string; readonly format: DataFormat | undefined }[];
  readonly limits: SandboxLimits;
  /** Owner that is charged for its memory: the session. [PM-58] */
  readonly owner: string;
  /** What ended the instance, of one that is created again. Default: it is new. [PM-54] */
  readonly previousFault?: ModuleFault | undefined;
}

/** Events and requests from a sandbox. */
export interface SandboxEvents {
  /** The module wrote to its console. [PM-14] */
  onLog(line: { readonly level: string; readonly text: string }): void;
  /** It has so many bytes of memory now; told when that changed. [PM-80] */
  onMemory?(bytes: number): void;
  /** Loads an asset set that the module asks for while it runs. Rejects with an `AssetError`. [PM-96] */
  onLoadAssets?(name: string): Promise<LoadedAssets>;
  /** The instance is gone; what was pending has rejected with the same fault. [PM-53] */
  onKilled(fault: ModuleFault): void;
}

/** One encoded record on its way into an instance. */
export interface SandboxRecord {
  readonly bytes: Uint8Array;
  /** True: the buffer may be transferred. */
  readonly isOwned?: boolean | undefined;
  /** Of an element of a muxer. [PM-43] */
  readonly identity?: string | undefined;
  /** Of an element of a muxer: when the node got it, milliseconds since the Unix epoch, master's clock. [PM-49] */
  readonly receivedAtMs?: number | undefined;
}

/** Value of one input. */
export type SandboxInput =
  | { readonly name: string; readonly record: SandboxRecord | undefined }
  | { readonly name: string; readonly elements: readonly SandboxRecord[] };

/** One run. */
export interface SandboxCall {
  readonly deltaTimeMs: number;
  /** When it starts, for `state.masterTimeMs`: milliseconds since the Unix epoch, master's clock. [PM-15] */
  readonly masterTimeMs?: number | undefined;
  readonly inputs: readonly SandboxInput[];
  /** Names of the inputs that caused it, for `state.inputTriggerNames`. [PM-12] */
  readonly triggers?: readonly string[] | undefined;
}

/** One value that was put out: an encoded `TopicDataRecord` with the value, and a timestamp if the module gave one. */
export interface SandboxValue {
  readonly bytes: Uint8Array;
  /** Number of the value member. */
  readonly valueField: number;
  readonly hasTimestamp: boolean;
}

/** Value of one output. */
export type SandboxOutput =
  | { readonly name: string; readonly value: SandboxValue }
  | {
      readonly name: string;
      readonly elements: readonly {
        readonly value: SandboxValue;
        /** Undefined when the element has none. [PM-46] */
        readonly params: readonly string[] | undefined;
        readonly identity: string | undefined;
        /** Place in the list the module gave. */
        readonly index: number;
      }[];
    };

/** Result of one run. */
export interface SandboxResult {
  readonly outputs: readonly SandboxOutput[];
  /** Outputs that were refused. [PM-33] [PM-56] */
  readonly faults: readonly ModuleFault[];
  /** Time in the module's code, milliseconds. */
  readonly durationMs: number;
}

/** One instance in its sandbox. One call at a time; every rejection is a `ModuleFault`. */
export interface Sandbox {
  /** Loads the code and calls onCreated. */
  create(): Promise<void>;
  run(call: SandboxCall): Promise<SandboxResult>;
  /** Calls onHalted. */
  halt(): Promise<void>;
  /** Calls onDestroyed and frees everything. */
  destroy(): Promise<void>;
  /** Frees everything at once; what is pending rejects. */
  terminate(): void;
}

/** The memory of all instances together, bytes. [PM-58] */
export interface SandboxMemory {
  /** Limit of all instances. */
  readonly limitBytes: number;
  /** Limit of the instances of one owner. */
  readonly ownerLimitBytes: number;
  /** Minimum memory of a sandboxed instance. */
  readonly leastBytes: number;
  /** Memory of all instances, or of those of one owner. */
  usedBytes(owner?: string): number;
}

/** Creates sandboxes for code. */
export interface SandboxFactory {
  /** Undefined when it is not counted. */
  readonly memory?: SandboxMemory | undefined;
  open(request: SandboxRequest, events: SandboxEvents): Sandbox;
  /** Whether the source parses and its callbacks are functions. Runs none of it on the calling thread. */
  check(source: ModuleSource): Promise<ModuleFault | undefined>;
  /** Ends all workers. */
  close(): Promise<void>;
}
