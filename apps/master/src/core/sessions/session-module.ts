import { MIN_MODULE_BYTES, type InstanceSpec } from '@ubii/pm-sandbox';
import {
  ProcessingModuleStatus,
  type IOMapping,
  type ModuleStatistics,
  type ProcessingModule,
  type SessionProblem,
} from '@ubii/proto';
import type { DraftModule } from './complete-modules.ts';

/** Phase of a module of a session. */
export type ModulePhase =
  /** Its session does not run. */
  | 'idle'
  /** Its node was asked to run it, and has not confirmed that it does. */
  | 'waiting'
  | 'running'
  /** It could not be started, or broke later. */
  | 'failed'
  /** Its node is not connected [SE-31]. */
  | 'away'
  /** Its node was asked to end it, and has not confirmed that it did. */
  | 'ending';

/** One module of one session. */
export class SessionModule {
  readonly id: string;
  readonly mapping: IOMapping;
  /** The node that the session names; undefined when the master chooses. */
  readonly requestedNodeId: string | undefined;
  /** The source is the library's own [PM-51]. */
  readonly isTrusted: boolean;
  #spec: ProcessingModule;
  #phase: ModulePhase = 'idle';
  #waitingSinceMs = 0;
  #problem: SessionProblem | undefined = undefined;
  #statistics: ModuleStatistics | undefined = undefined;

  constructor({ spec, mapping, requestedNodeId, isLibraryCode }: DraftModule) {
    this.id = spec.id;
    this.#spec = spec;
    this.mapping = mapping;
    this.requestedNodeId = requestedNodeId;
    this.isTrusted = isLibraryCode;
  }

  /** Complete; `nodeId` is the node that it was given to last. */
  get spec(): ProcessingModule {
    return this.#spec;
  }

  get phase(): ModulePhase {
    return this.#phase;
  }

  /** When it was given to its node last, or its node last reported that it loads, monotonic milliseconds. */
  get waitingSinceMs(): number {
    return this.#waitingSinceMs;
  }

  /** Why it does not run as it should. */
  get problem(): SessionProblem | undefined {
    return this.#problem;
  }

  get statistics(): ModuleStatistics | undefined {
    return this.#statistics;
  }

  /** Names the node that would run it [SE-30]. */
  assign(spec: ProcessingModule): void {
    this.#spec = spec;
  }

  /** Gives it to a node, which is `spec.nodeId`. */
  place(spec: ProcessingModule, nowMs: number): void {
    if (spec.nodeId !== this.nodeId) this.#statistics = undefined;
    this.#spec = spec;
    this.restart(nowMs);
  }

  /** Its node creates it again, and reports when it runs. */
  restart(nowMs: number): void {
    this.#phase = 'waiting';
    this.#problem = undefined;
    this.#waitingSinceMs = nowMs;
  }

  /** No connected node can run it [SE-31]. */
  handleNodeGone(problem: SessionProblem): void {
    this.#phase = 'away';
    this.#problem = problem;
  }

  /** Its node runs it. */
  handleRunning(): void {
    this.#phase = 'running';
    this.#problem = undefined;
  }

  handleFailed(problem: SessionProblem): void {
    this.#phase = 'failed';
    this.#problem = problem;
  }

  /** Its node has not started it in time: it may still start [SE-12]. */
  handleLate(problem: SessionProblem): void {
    this.#problem = problem;
  }

  /** @param isAwaited its node has to confirm that it ended [SE-13] */
  end(isAwaited: boolean): void {
    // The session does not wait for the node any more.
    if (this.#phase === 'away') this.#problem = undefined;
    this.#phase = isAwaited ? 'ending' : 'idle';
  }

  /** Continues as the module that it replaces, on its node [SE-15]. */
  continueFrom(old: SessionModule): void {
    const { nodeId, language } = old.spec;
    this.#spec = { ...this.#spec, nodeId, language };
    this.#phase = old.phase;
    this.#problem = old.problem;
    this.#statistics = old.statistics;
    this.#waitingSinceMs = old.waitingSinceMs;
  }

  clearStatistics(): void {
    this.#statistics = undefined;
  }

  /** Keeps what its node reported. Loading asset sets does not count as late, however slow the network is [SE-12]. */
  recordStatistics(statistics: ModuleStatistics, nowMs: number): void {
    this.#statistics = statistics;
    if (this.#phase === 'waiting' && statistics.loadingSet !== '') this.#waitingSinceMs = nowMs;
  }

  get nodeId(): string {
    return this.#spec.nodeId;
  }

  get name(): string {
    return this.#spec.name;
  }

  get isLockstep(): boolean {
    return this.#spec.processingMode?.lockstep !== undefined;
  }

  /** Its node may have an instance of it. */
  get isPlaced(): boolean {
    return this.#phase === 'waiting' || this.#phase === 'running' || this.#phase === 'failed';
  }

  /** Memory it has, or at least will take, bytes. */
  get memoryBytes(): number {
    if (!this.isPlaced || this.#phase === 'failed') return 0;
    return Math.max(this.#statistics?.memoryBytes ?? 0, this.minMemoryBytes);
  }

  /** Minimum memory, bytes; trusted modules share the heap of their worker. */
  get minMemoryBytes(): number {
    return this.isTrusted ? 0 : MIN_MODULE_BYTES;
  }

  /** The specification of its instance. */
  toSpec(sessionId: string, isPaused: boolean): InstanceSpec {
    const { mapping, isTrusted } = this;
    return { module: this.toMessage(sessionId, isPaused), mapping, isTrusted };
  }

  /** The module on the wire. */
  toMessage(sessionId: string, isPaused: boolean): ProcessingModule {
    const { version = '', origin = 0 } = this.#spec.extension ?? {};
    const { libraries = [], assets = [], optionalAssets = [] } = this.#spec.extension ?? {};
    return {
      ...this.#spec,
      sessionId,
      status: this.#status(isPaused),
      // [EX-22]
      extension: {
        version,
        libraries,
        assets,
        optionalAssets,
        origin,
        replaceable: this.requestedNodeId === undefined,
        grantIds: [],
      },
    };
  }

  #status(isPaused: boolean): ProcessingModuleStatus {
    if (this.#phase === 'running') {
      return isPaused ? ProcessingModuleStatus.HALTED : ProcessingModuleStatus.PROCESSING;
    }
    return this.#phase === 'ending' || this.#phase === 'failed'
      ? ProcessingModuleStatus.DESTROYED
      : ProcessingModuleStatus.INITIALIZED;
  }
}
