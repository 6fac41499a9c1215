import type { PatternSource } from '@ubii/patterns';
import type { Init, ModuleEvent, ProcessingModule } from '@ubii/proto';
import type {
  AssetStore,
  ModuleRuntime,
  ModuleRuntimeOptions,
  RuntimeLimits,
  SandboxFactory,
} from '@ubii/pm-sandbox';
import type { Clock } from '@ubii/timing';
import type { Unsubscribe } from '../core/client/ubii-client.ts';
import type { NodeInstance } from './node-instance.ts';

/** Options of a node. */
export interface ProcessingNodeOptions {
  /** Sandboxes for the code. The node does not close them. */
  readonly sandboxes: SandboxFactory;
  /** Kind of the program. */
  readonly kind: 'browser' | 'node';
  /** Modules with code of this program, which is trusted. [PM-51] @default none */
  readonly modules?: readonly Init<ProcessingModule>[];
  /** Whether the master may choose this node by itself. @default true */
  readonly acceptsWork?: boolean;
  /** True when the program exists to run modules for others. @default false */
  readonly isDedicated?: boolean;
  /** Names of the libraries the sandboxes offer in `state.modules`. @default none */
  readonly libraries?: readonly string[];
  /** Loads the asset sets of trusted modules into `state.assets`. @default none: such modules cannot run here */
  readonly assets?: AssetStore;
  /** True: the program makes recordings for the master. [RC-60] @default false */
  readonly records?: boolean;
  /** Number of modules that it accepts at once; 0: not specified. @default 0 */
  readonly capacity?: number;
  readonly limits?: Partial<RuntimeLimits>;
  /** @default the system's, in a page one that keeps time while the page is hidden */
  readonly clock?: Clock;
  /** Matches the regular expressions of muxers. @default RE2, loaded when a module needs it */
  readonly patterns?: PatternSource;
  /** Makes the runtime, for tests. @default createModuleRuntime of `@ubii/pm-sandbox` */
  readonly createRuntime?: (options: ModuleRuntimeOptions) => ModuleRuntime;
}

/** A client that runs processing modules of sessions. */
export interface ProcessingNode {
  /**
   * Takes part from now on: as soon as the client is connected, and again after every reconnect.
   * Rejects with the `ServiceError` when the master refuses what the node says of itself.
   */
  start(): Promise<void>;
  /** Ends all modules, tells the master, and takes part no longer; may be started again. */
  stop(): Promise<void>;
  readonly isStarted: boolean;
  /** Other modules to offer from now on. Those that run keep their code until their session changes or starts again. */
  setModules(modules: readonly Init<ProcessingModule>[]): Promise<void>;
  /** Whether the master may choose this node by itself, from now on. */
  setAcceptsWork(acceptsWork: boolean): Promise<void>;
  /** The modules of sessions that are here, in the order they came. */
  readonly instances: readonly NodeInstance[];
  /** Calls `fn` after `instances` changed, at most once a turn. */
  onChange(fn: (instances: readonly NodeInstance[]) => void): Unsubscribe;
  /** Calls `fn` for what the modules do that people want to know: errors, log lines, restarts. */
  onEvent(fn: (event: ModuleEvent) => void): Unsubscribe;
}
