import type { ModuleFault } from '../ports/module-fault.ts';
import type { IoInits, ModuleInputs, ModuleOutputs } from './io-types.ts';

/** When a module runs; nothing means 30 Hz. */
export type ModeInit =
  /** At fixed intervals. [PM-21] */
  | { readonly frequency: { readonly hertz: number } }
  /** When any input was updated, or all of them; not more often than the delay allows. [PM-23] */
  | {
      readonly triggerOnInput: {
        readonly minDelayMs?: number;
        readonly allInputsNeedUpdate?: boolean;
      };
    }
  /** In the passes of its session. [PM-27] */
  | { readonly lockstep: Readonly<Record<string, never>> }
  /** Again and again. [PM-28] */
  | { readonly free: Readonly<Record<string, never>> };

/** Members that the node adds to the state of an instance. [PM-12] */
export interface NodeState {
  /** The external libraries and those of the asset sets that the module asked for, by name. */
  readonly modules: Readonly<Record<string, unknown>>;
  /** Files of the asset sets that the module asked for, by name and path. [PM-90] */
  readonly assets: Readonly<Record<string, Readonly<Record<string, Uint8Array<ArrayBuffer>>>>>;
  /**
   * Loads one of the `optionalAssets` of the module. Resolves with its files by path, rejects when the set is
   * missing, damaged or unreachable: `code` says which, `message` is for people. A call that awaits it is waiting;
   * loading may take longer than one call may wait. [PM-96]
   */
  readonly loadAssets: (name: string) => Promise<Readonly<Record<string, Uint8Array<ArrayBuffer>>>>;
  /** What ended the instance before it was created again, of trusted modules; undefined: it is new. [PM-54] */
  readonly previousFault?: ModuleFault | undefined;
  /** When the run began, milliseconds since the Unix epoch, master's clock, on every node. [PM-15] */
  masterTimeMs: number;
  /** With the mode trigger-on-input: inputs that were updated since the run before. */
  inputTriggerNames: readonly string[];
}

/** State of an instance: its own members and those of the node. */
export type ModuleState<S> = S & NodeState;

/** Return value of `onProcessing`. [PM-11] */
export interface ProcessingResult<O extends IoInits, S> {
  readonly outputs?: ModuleOutputs<O> | undefined;
  /** Replaces the state. */
  readonly state?: S | undefined;
}

type MaybePromise<T> = T | Promise<T>;

/**
 * A processing module as its author writes it. The callbacks may be taken to another place as text:
 * they see their parameters, `console` and what the language offers, and nothing else. [PM-2]
 */
export interface ModuleDefinition<
  I extends IoInits = IoInits,
  O extends IoInits = IoInits,
  S extends object = Record<string, unknown>,
> {
  readonly name: string;
  readonly description?: string;
  readonly tags?: readonly string[];
  readonly authors?: readonly string[];
  /** Semantic versioning. */
  readonly version?: string;
  /** Libraries that the module needs in `state.modules`; a node without one of them cannot run it. [PM-4] */
  readonly libraries?: readonly string[];
  /** Names of the asset sets it needs in `state.assets`; only trusted modules get them. [PM-90] */
  readonly assets?: readonly string[];
  /** Names of the asset sets it may load with `state.loadAssets`; only trusted modules get them. [PM-96] */
  readonly optionalAssets?: readonly string[];
  readonly inputs: I;
  readonly outputs: O;
  /** Default: 30 Hz. */
  readonly mode?: ModeInit;
  /** The first state; called once, before `onCreated`. It gives the state its type. */
  createState?(): S;
  onCreated?(state: ModuleState<S>): MaybePromise<void>;
  /** @param deltaTimeMs milliseconds since the previous start of a run, 0 in the first */
  onProcessing(
    deltaTimeMs: number,
    inputs: ModuleInputs<I>,
    state: ModuleState<S>,
  ): MaybePromise<ProcessingResult<O, NoInfer<S>> | void>;
  onHalted?(state: ModuleState<S>): MaybePromise<void>;
  onDestroyed?(state: ModuleState<S>): MaybePromise<void>;
}

/** A definition of whatever types, as lists of modules hold them. */
// eslint-disable-next-line @typescript-eslint/no-explicit-any -- the callbacks' parameters are of any type
export type AnyModuleDefinition = ModuleDefinition<any, any, any>;

/**
 * Checks a definition's types and returns it: inputs, outputs and state of the callbacks follow from
 * the declared formats.
 */
export function defineProcessingModule<
  const I extends IoInits,
  const O extends IoInits,
  S extends object = Record<string, unknown>,
>(definition: ModuleDefinition<I, O, S>): ModuleDefinition<I, O, S> {
  return definition;
}
