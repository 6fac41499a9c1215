import type { IOMapping, ModuleStatistics, ProcessingMode, ProcessingModule } from '@ubii/proto';
import type { EncodedRecord } from '../ports/topic-port.ts';

/** One module of a session, ready to be made. */
export interface InstanceSpec {
  /** Complete: `id` is the instance's, `sessionId` is set. */
  readonly module: ProcessingModule;
  readonly mapping: IOMapping;
  /** Whether its code is trusted. [PM-51] */
  readonly isTrusted: boolean;
}

/** One share of a lockstep pass. */
export interface PassRequest {
  readonly instanceIds: readonly string[];
  readonly deltaTimeMs: number;
  /** The snapshot: inputs of all these instances, distinguished by topic. */
  readonly records: readonly EncodedRecord[];
}

/** Outputs of a pass. */
export interface PassReply {
  /** The instances that ran. */
  readonly instanceIds: readonly string[];
  /** Complete encoded records, in the order of the instances; not published. */
  readonly records: readonly Uint8Array[];
}

/** The modules of one node. Faults reach `onEvent` and `onStatus`; only `create` and `runPass` tell their caller. */
export interface ModuleRuntime {
  /** Opens the sandbox and calls onCreated. Rejects with a `ModuleFault`. */
  create(spec: InstanceSpec): Promise<void>;
  /** Lets it process as its mode says; after `halt` with the state it has. */
  start(instanceId: string): void;
  /** [PM-29] */
  halt(instanceId: string): Promise<void>;
  destroy(instanceId: string): Promise<void>;
  /** Other mappings from now on, without a restart. */
  remap(instanceId: string, mapping: IOMapping): void;
  /** Another mode from now on, without a restart. */
  setMode(instanceId: string, mode: ProcessingMode | undefined): void;
  /** The newest records of all inputs of these instances, each topic once. [SE-40] */
  lockstepInputs(instanceIds: readonly string[]): EncodedRecord[];
  /** Runs each once on the snapshot. Settles when all have run or failed. [PM-27] */
  runPass(pass: PassRequest): Promise<PassReply>;
  has(instanceId: string): boolean;
  readonly instanceCount: number;
  /** Of all instances, since the call before. */
  statistics(): ModuleStatistics[];
  /** Destroys all. */
  close(): Promise<void>;
}
