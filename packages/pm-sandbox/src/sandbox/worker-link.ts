import type { Cancel } from '@ubii/timing';
import type { HostBatch, Progress, WorkerBatch, WorkerStart } from '../worker/protocol.ts';
import type { PoolMemoryOptions } from './pool-memory.ts';

/** One worker as its host sees it. */
export interface WorkerLink {
  post(batch: HostBatch, transfer: readonly ArrayBuffer[]): void;
  /** Returns the known progress of the worker. */
  progress(): Progress;
  /** Whether something is under way that the program should stay alive for. */
  setActive(isActive: boolean): void;
  /** Ends it at once. `onExit` is not called. */
  terminate(): void;
}

/** Takes what a worker tells. */
export interface WorkerListener {
  onBatch(batch: WorkerBatch): void;
  /** It runs no code any more: after it was ended, or ended by itself. */
  onGone(): void;
  /** It ended by itself. */
  onExit(reason: { readonly kind: 'memory' | 'exit'; readonly message: string }): void;
}

/** Functions of a platform for the pool of workers. */
export interface PoolPlatform {
  startWorker(start: WorkerStart, listener: WorkerListener): WorkerLink;
  every(intervalMs: number, fn: () => void): Cancel;
  /** CPU time of all threads of the program, milliseconds; left out where it is not known. */
  cpuMs?(): number;
  /** Calls `fn` once what is running now is done. */
  atEndOfTurn(fn: () => void): void;
}

/** A library of the host: methods that take and give what can be JSON, and reject with a sentence. */
export type HostLibrary = Readonly<Record<string, (...args: unknown[]) => Promise<unknown>>>;

/** Options of a pool of workers. */
export interface PoolOptions {
  /** Module specifiers of libraries that trusted code gets, by name. */
  readonly libraries: Readonly<Record<string, string>>;
  /** Libraries that the host runs, for all code. */
  readonly hostLibraries: Readonly<Record<string, HostLibrary>>;
  /** Workers for sandboxed modules, for trusted ones, and for those with asset sets; those of killed instances come on top. */
  readonly maxWorkers: number;
  /** Memory of sandboxed instances. [PM-58] */
  readonly memory: PoolMemoryOptions;
}
