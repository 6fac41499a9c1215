import { MIN_MODULE_BYTES, type InstanceSpec } from '@ubii/pm-sandbox';
import {
  ProcessingModuleStatus,
  type IOMapping,
  type ModuleStatistics,
  type ProcessingModule,
  type SessionProblem,
} from '@ubii/proto';

/** Phase of a module of a session. */
export type ModulePhase =
  /** Its session does not run. */
  | 'idle'
  /** Its node was told to run it, and has not said that it does. */
  | 'waiting'
  | 'running'
  /** It could not be started, or broke later. */
  | 'failed'
  /** Its node is gone [SE-31]. */
  | 'away'
  /** Its node was told to end it, and has not said that it did. */
  | 'ending';

/** One module of one session. */
export class SessionModule {
  readonly id: string;
  /** Complete; `nodeId` is that of the node it was given to last. */
  spec: ProcessingModule;
  mapping: IOMapping;
  /** The node that the session names; empty when the master chooses. */
  wishedNodeId: string;
  /** The source is the library's own [PM-51]. */
  isTrusted: boolean;
  phase: ModulePhase = 'idle';
  /** When it was given to its node last, or its node last said that it loads, monotonic milliseconds. */
  waitingSinceMs = 0;
  /** Why it does not run as it should. */
  problem: SessionProblem | undefined = undefined;
  statistics: ModuleStatistics | undefined = undefined;

  constructor(parts: {
    readonly spec: ProcessingModule;
    readonly mapping: IOMapping;
    readonly wishedNodeId: string;
    readonly isTrusted: boolean;
  }) {
    this.id = parts.spec.id;
    this.spec = parts.spec;
    this.mapping = parts.mapping;
    this.wishedNodeId = parts.wishedNodeId;
    this.isTrusted = parts.isTrusted;
  }

  /** Its node reported how it does. What loads its asset sets is not late, however slow the network is [SE-12]. */
  noteStatistics(statistics: ModuleStatistics, nowMs: number): void {
    this.statistics = statistics;
    if (this.phase === 'waiting' && statistics.loadingSet !== '') this.waitingSinceMs = nowMs;
  }

  get nodeId(): string {
    return this.spec.nodeId;
  }

  get name(): string {
    return this.spec.name;
  }

  get isLockstep(): boolean {
    return this.spec.processingMode?.lockstep !== undefined;
  }

  /** Whether its node may have an instance of it. */
  get isPlaced(): boolean {
    return this.phase === 'waiting' || this.phase === 'running' || this.phase === 'failed';
  }

  /** Memory it has, bytes, or is about to take at least. */
  get memoryBytes(): number {
    if (!this.isPlaced || this.phase === 'failed') return 0;
    return Math.max(this.statistics?.memoryBytes ?? 0, this.leastMemoryBytes);
  }

  /** Memory it takes at least, bytes; trusted ones share the heap of their worker. */
  get leastMemoryBytes(): number {
    return this.isTrusted ? 0 : MIN_MODULE_BYTES;
  }

  /** The module as an instance is made of it. */
  toSpec(sessionId: string, isPaused: boolean): InstanceSpec {
    const { mapping, isTrusted } = this;
    return { module: this.toMessage(sessionId, isPaused), mapping, isTrusted };
  }

  /** The module as others see it. */
  toMessage(sessionId: string, isPaused: boolean): ProcessingModule {
    const { version = '', origin = 0 } = this.spec.extension ?? {};
    const { libraries = [], assets = [], optionalAssets = [] } = this.spec.extension ?? {};
    return {
      ...this.spec,
      sessionId,
      status: this.#status(isPaused),
      // [EX-22]
      extension: {
        version,
        libraries,
        assets,
        optionalAssets,
        origin,
        replaceable: this.wishedNodeId === '',
        grantIds: [],
      },
    };
  }

  #status(isPaused: boolean): ProcessingModuleStatus {
    if (this.phase === 'running') {
      return isPaused ? ProcessingModuleStatus.HALTED : ProcessingModuleStatus.PROCESSING;
    }
    return this.phase === 'ending' || this.phase === 'failed'
      ? ProcessingModuleStatus.DESTROYED
      : ProcessingModuleStatus.INITIALIZED;
  }
}
