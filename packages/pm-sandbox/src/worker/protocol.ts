import type { AssetErrorCode } from '../assets/asset-error.ts';
import type { LoadedAssets } from '../assets/asset-store.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { ModuleSource, SandboxRequest } from '../ports/sandbox.ts';
import type { MemoryCells } from './memory-account.ts';
import type { ResultMessage, RunMessage } from './run-wire.ts';

/** Engine of a worker. [PM-51] */
export type WorkerKind = 'trusted' | 'sandboxed';

/** Methods of the libraries that the host runs, by library. */
export type HostLibraryNames = Readonly<Record<string, readonly string[]>>;

/**
 * All that a host tells a worker. `instance` is a number of the host's, `call` one that its answer
 * carries.
 */
export type HostMessage =
  | RunMessage
  | {
      readonly kind: 'create';
      readonly instance: number;
      readonly call: number;
      readonly request: Omit<SandboxRequest, 'assets'>;
      /** Keys of its asset sets, which the worker has by then. */
      readonly assets: readonly string[];
      /** Owner that is charged for its memory. */
      readonly owner: number;
    }
  /** Files for all instances that name the set. */
  | { readonly kind: 'assets'; readonly assets: LoadedAssets }
  /** No instance needs the set any more. */
  | { readonly kind: 'dropAssets'; readonly key: string }
  | { readonly kind: 'halt'; readonly instance: number; readonly call: number }
  | { readonly kind: 'destroy'; readonly instance: number; readonly call: number }
  /** Frees an instance without calling it. */
  | { readonly kind: 'free'; readonly instance: number }
  | {
      readonly kind: 'check';
      readonly instance: number;
      readonly call: number;
      readonly source: ModuleSource;
    }
  /** Answer to a `loadAssets`: the key of a set, which the worker has by then, or why there is none. */
  | {
      readonly kind: 'assetsAnswer';
      readonly request: number;
      readonly result:
        | { readonly key: string }
        | { readonly code: AssetErrorCode; readonly message: string };
    }
  /** Answer to a `libraryCall`. */
  | {
      readonly kind: 'libraryAnswer';
      readonly request: number;
      readonly isFulfilled: boolean;
      /** JSON value; a sentence when it is invalid. */
      readonly value: unknown;
    };

/** All that a worker tells its host. */
export type WorkerMessage =
  | ResultMessage
  | { readonly kind: 'ready' }
  /** A call that is no run ended well; `fault` is what a check found. */
  | { readonly kind: 'done'; readonly call: number; readonly fault: ModuleFault | undefined }
  | { readonly kind: 'failed'; readonly call: number; readonly fault: ModuleFault }
  /** The instance is gone. What was pending of it has failed before. */
  | { readonly kind: 'killed'; readonly instance: number; readonly fault: ModuleFault }
  | {
      readonly kind: 'log';
      readonly instance: number;
      readonly level: string;
      readonly text: string;
    }
  /** It has another amount of memory than before, bytes. */
  | { readonly kind: 'memory'; readonly instance: number; readonly bytes: number }
  /** A module asks for one of its optional asset sets. */
  | {
      readonly kind: 'loadAssets';
      readonly instance: number;
      readonly request: number;
      readonly name: string;
    }
  | {
      readonly kind: 'libraryCall';
      readonly instance: number;
      readonly request: number;
      readonly library: string;
      readonly method: string;
      readonly args: readonly unknown[];
    };

/** Messages of one turn travel together. */
export interface HostBatch {
  readonly messages: readonly HostMessage[];
}

/** Messages of one turn travel together. */
export interface WorkerBatch {
  readonly messages: readonly WorkerMessage[];
  /** Progress of the worker, where it is not visible in shared memory. */
  readonly progress?: Progress | undefined;
}

/** Progress of a worker. */
export interface Progress {
  /** Batches it has begun. */
  readonly received: number;
  /** Instance whose code is running; 0 when none. */
  readonly running: number;
  /** Grows with each time an instance's code begins to run. */
  readonly sequence: number;
}

/** First message to a worker. */
export interface WorkerStart {
  readonly kind: WorkerKind;
  /** Memory budget of sandboxed instances. */
  readonly memory: MemoryCells;
  readonly hostLibraries: HostLibraryNames;
  /** Module specifiers of libraries that trusted code gets, by name. */
  readonly libraries: Readonly<Record<string, string>>;
}
