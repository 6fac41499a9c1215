import type { LoadedAssets } from '../assets/asset-store.ts';
import type { ModuleFault, ModulePhase } from '../ports/module-fault.ts';
import type { ModuleSource, SandboxLimits } from '../ports/sandbox.ts';
import type { RawOutput } from './encode-outputs.ts';
import type { InputValues } from './module-records.ts';

/** A value that may come later. Engines answer at once where they can: a promise costs a turn. */
export type MaybePromise<T> = T | Promise<T>;

/** Callbacks of an engine while code runs. */
export interface EngineHooks {
  onLog(level: string, text: string): void;
  /** Calls a method of a library that the host runs; rejects with a sentence. */
  callHost(library: string, method: string, args: readonly unknown[]): Promise<unknown>;
  /** Loads an optional asset set; rejects with an `AssetError`. [PM-96] */
  loadAssets(name: string): Promise<LoadedAssets['files']>;
  /** The module's code is about to go on, outside of a call. */
  onResume(): void;
  /** The module's code failed permanently outside of a call; what is given is as if thrown by one. */
  onFailure(thrown: unknown): void;
}

/** The module that an engine loads. */
export interface EngineRequest {
  readonly source: ModuleSource;
  readonly limits: SandboxLimits;
  /** Names of the outputs, in order. */
  readonly outputNames: readonly string[];
  /** Libraries that are loaded where the code runs. */
  readonly modules: Readonly<Record<string, unknown>>;
  /** Files by set and path. [PM-90] */
  readonly assets: Readonly<Record<string, LoadedAssets['files']>>;
  /** What ended the instance before it was created again; undefined: it is new. */
  readonly previousFault?: ModuleFault | undefined;
  /** Owner that is charged for its memory; undefined: its memory is not counted. [PM-58] */
  readonly owner?: number | undefined;
  /** Methods of the libraries that the host runs. */
  readonly hostLibraries: Readonly<Record<string, readonly string[]>>;
}

/** Result of `onProcessing`. */
export interface RawResult {
  readonly outputs: readonly RawOutput[];
  /** Problem with the result as a whole, one sentence. */
  readonly problem: string | undefined;
  /** Outputs that it has and the module does not declare; only some of many. */
  readonly undeclared?: readonly string[] | undefined;
}

/** The code of one instance in its engine. What it throws and rejects with are `ModuleError`s. */
export interface EngineInstance {
  /** Calls a callback with the state; nothing when the module has none of that name. */
  call(phase: Exclude<ModulePhase, '' | 'onProcessing'>): MaybePromise<void>;
  /** Calls `onProcessing`. [PM-11] */
  process(
    deltaTimeMs: number,
    inputs: InputValues,
    triggers: readonly string[] | undefined,
    masterTimeMs: number | undefined,
  ): MaybePromise<RawResult>;
  /** Frees what it holds; no call may follow. */
  free(): void;
  /** Bytes of memory it has; engines that share theirs do not know. */
  memoryBytes?(): number;
}

/** Something that runs source text. */
export interface Engine {
  /** @throws ModuleError of kind `syntax` or `missing` */
  open(request: EngineRequest, hooks: EngineHooks): MaybePromise<EngineInstance>;
}
