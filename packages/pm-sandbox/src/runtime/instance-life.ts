import { ModuleEventKind, ProcessingModuleStatus } from '@ubii/proto';
import { within, type Cancel } from '@ubii/timing';
import type { ModuleFault, ModulePhase } from '../ports/module-fault.ts';
import type { Sandbox, SandboxRequest } from '../ports/sandbox.ts';
import { nextStatus, wireStatus, type InstanceMove, type InstanceStatus } from './lifecycle.ts';
import type { InstanceSpec } from './module-runtime.ts';
import type { InstanceReports } from './reports/instance-reports.ts';
import { RestartPolicy } from './restart-policy.ts';
import type { Runner } from './runner.ts';
import type { RuntimeContext } from './runtime-context.ts';
import { sandboxRequest } from './prepare-sandbox.ts';
import { isDeadly, toFault } from './to-fault.ts';
import { loadAssets, loadOptionalAssets } from './prepare-sandbox.ts';

/** Callbacks of the life of an instance. */
export interface LifeEvents {
  /** Runs may start. */
  onStart(): void;
  /** No run may start any more. */
  onStop(): void;
  /** It needs no inputs any more. */
  onEnd(): void;
}

const ENDED_MEANWHILE: ModuleFault = {
  kind: 'crashed',
  phase: 'onCreated',
  message: 'The module was stopped while it was starting.',
};

/** Life of one instance: its sandbox, the moves between its states, its restarts. [PM-10] */
export class InstanceLife {
  readonly #spec: InstanceSpec;
  readonly #context: RuntimeContext;
  readonly #reports: InstanceReports;
  readonly #runner: Runner;
  readonly #events: LifeEvents;
  readonly #restarts: RestartPolicy;
  #status: InstanceStatus = 'creating';
  #reportedStatus: ProcessingModuleStatus = ProcessingModuleStatus.INITIALIZED;
  #sandbox: Sandbox | undefined;
  /** It is to process as soon as it can. */
  #wantsRuns = false;
  #cancelRestart: Cancel | undefined;
  /** What ended it before. */
  #previousFault: ModuleFault | undefined;
  /** Ends the loading of its asset sets. */
  #loading: AbortController | undefined;
  #halting: Promise<void> | undefined;
  #destroying: Promise<void> | undefined;

  constructor(
    spec: InstanceSpec,
    context: RuntimeContext,
    reports: InstanceReports,
    runner: Runner,
    events: LifeEvents,
  ) {
    this.#spec = spec;
    this.#context = context;
    this.#reports = reports;
    this.#runner = runner;
    this.#events = events;
    this.#restarts = new RestartPolicy(context.limits);
  }

  get isProcessing(): boolean {
    return this.#status === 'processing';
  }

  get wireStatus(): ProcessingModuleStatus {
    return wireStatus(this.#status) ?? this.#reportedStatus;
  }

  /** Resolves with why it cannot start, or with nothing. [PM-13] */
  async create(): Promise<ModuleFault | undefined> {
    const fault = await this.#open();
    if (this.#status !== 'creating') return fault ?? ENDED_MEANWHILE;
    if (fault !== undefined) {
      this.#reports.countError(fault);
      this.#end(fault);
      return fault;
    }
    this.#move('created');
    this.#startIfWanted();
    return undefined;
  }

  start(): void {
    if (this.#destroying !== undefined) return;
    this.#wantsRuns = true;
    this.#startIfWanted();
  }

  /** [PM-29] */
  halt(): Promise<void> {
    this.#wantsRuns = false;
    if (this.#status === 'processing') this.#halting = this.#haltNow();
    return this.#halting ?? Promise.resolve();
  }

  destroy(): Promise<void> {
    this.#loading?.abort();
    this.#destroying ??= this.#destroyNow();
    return this.#destroying;
  }

  /** A callback failed: a fatal fault ends the instance. [PM-13] [PM-53] */
  handleFault(fault: ModuleFault): void {
    if (isDeadly(fault)) this.#handleKilled(fault);
    else this.#reports.countError(fault);
  }

  #startIfWanted(): void {
    if (!this.#wantsRuns || !this.#move('start')) return;
    this.#events.onStart();
  }

  /** Opens a sandbox and calls onCreated. Returns why that failed. */
  async #open(): Promise<ModuleFault | undefined> {
    const { limits, libraries, sandboxes } = this.#context;
    const request = sandboxRequest(this.#spec, limits, libraries);
    if ('fault' in request) return request.fault;
    let assets: SandboxRequest['assets'] = [];
    // Without an await for those that need none: they start in this turn.
    this.#loading = new AbortController();
    const { signal } = this.#loading;
    const { assets: names = [], optionalAssets = [] } = this.#spec.module.extension ?? {};
    if (names.length + optionalAssets.length > 0) {
      const loaded = await loadAssets(this.#spec, this.#context, this.#reports, signal);
      if ('fault' in loaded) return loaded.fault;
      if (signal.aborted) return ENDED_MEANWHILE;
      assets = loaded.sets;
    }
    let sandbox: Sandbox | undefined;
    try {
      sandbox = sandboxes.open(
        { ...request, assets, previousFault: this.#previousFault },
        {
          onLog: ({ level, text }) => this.#reports.log(level, text),
          onMemory: (bytes) => {
            if (sandbox === this.#sandbox) this.#reports.noteMemory(bytes);
          },
          onLoadAssets: (name) =>
            loadOptionalAssets(name, this.#spec, this.#context, this.#reports, signal),
          onKilled: (fault) => {
            if (sandbox === this.#sandbox) this.#handleKilled(fault);
          },
        },
      );
      this.#sandbox = sandbox;
      await sandbox.create();
    } catch (reason) {
      if (sandbox === this.#sandbox) this.#dropSandbox();
      return toFault(reason, 'onCreated');
    }
    if (sandbox !== this.#sandbox) return ENDED_MEANWHILE;
    this.#runner.attach(sandbox);
    return undefined;
  }

  async #haltNow(): Promise<void> {
    this.#move('halt');
    this.#events.onStop();
    const sandbox = this.#sandbox;
    const { clock, limits } = this.#context;
    const hasEnded = await within(clock, limits.haltTimeoutMs, this.#runner.whenIdle());
    if (sandbox === undefined || sandbox !== this.#sandbox) return;
    if (!hasEnded) return this.#handleLate('onProcessing');
    await this.#call('onHalted', sandbox.halt());
    if (sandbox !== this.#sandbox) return;
    this.#move('halted');
    this.#startIfWanted();
  }

  async #destroyNow(): Promise<void> {
    await this.halt();
    this.#cancelRestart?.();
    this.#events.onEnd();
    const sandbox = this.#sandbox;
    const hasState = this.#status === 'created' || this.#status === 'halted';
    if (this.#status === 'destroyed') return;
    this.#move('destroy');
    if (sandbox !== undefined) {
      if (hasState) await this.#call('onDestroyed', sandbox.destroy());
      this.#dropSandbox();
    }
    this.#move('destroyed');
    this.#reports.close();
  }

  /** Waits for a last callback. One that fails changes nothing, one that does not end is killed. */
  async #call(phase: ModulePhase, work: Promise<void>): Promise<void> {
    const { clock, limits } = this.#context;
    try {
      if (!(await within(clock, limits.haltTimeoutMs, work))) this.#handleLate(phase);
    } catch (reason) {
      // The end of a sandbox that is gone was reported already.
      if (this.#sandbox !== undefined) this.handleFault(toFault(reason, phase));
    }
  }

  #handleLate(phase: ModulePhase): void {
    const message = `${phase} did not end within ${this.#context.limits.haltTimeoutMs} ms after the module was halted.`;
    this.#handleKilled({ kind: 'timeout', phase, message });
  }

  #handleKilled(fault: ModuleFault): void {
    // While it is created, the failed call says the same.
    if (this.#status === 'creating' || this.#status === 'recreating') return;
    if (this.#runner.isBusy) this.#reports.countLostRun();
    this.#events.onStop();
    this.#dropSandbox();
    this.#reports.fault(ModuleEventKind.KILLED, fault);
    if (this.#move('kill', fault)) this.#planRestart(fault);
  }

  // [PM-54]
  #planRestart(fault: ModuleFault): void {
    this.#previousFault = fault;
    const { clock } = this.#context;
    const delayMs = this.#restarts.next(clock.monotonicMs());
    if (delayMs === undefined) {
      this.#reports.reportFailed(fault);
      this.#end(fault);
      return;
    }
    this.#cancelRestart = clock.after(delayMs, () => void this.#recreate());
  }

  async #recreate(): Promise<void> {
    this.#move('recreate');
    const fault = await this.#open();
    if (this.#status !== 'recreating') return;
    if (fault !== undefined) {
      this.#reports.countError(fault);
      if (this.#move('kill', fault)) this.#planRestart(fault);
      return;
    }
    this.#reports.countRestart();
    this.#move('created');
    this.#startIfWanted();
  }

  #end(fault: ModuleFault): void {
    this.#move('fail', fault);
    this.#events.onEnd();
  }

  #dropSandbox(): void {
    this.#loading?.abort();
    const sandbox = this.#sandbox;
    this.#sandbox = undefined;
    this.#reports.noteMemory(0);
    this.#runner.detach();
    sandbox?.terminate();
  }

  #move(move: InstanceMove, fault?: ModuleFault): boolean {
    const next = nextStatus(this.#status, move);
    if (next === undefined) return false;
    this.#status = next;
    const status = this.wireStatus;
    if (status !== this.#reportedStatus) {
      this.#reportedStatus = status;
      this.#context.onStatus(this.#spec.module.id, status, fault);
    }
    return true;
  }
}
