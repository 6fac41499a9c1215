import type { Clock } from '@ubii/timing';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { Sandbox, SandboxInput, SandboxResult } from '../ports/sandbox.ts';
import { toFault } from './to-fault.ts';

/** One run. */
export interface RunCall {
  readonly inputs: readonly SandboxInput[];
  readonly triggers?: readonly string[] | undefined;
  /** Given by the session in a pass; else the time since the start of the run before. [PM-11] */
  readonly deltaTimeMs?: number | undefined;
}

/** Callbacks for the outcome of a run. */
export interface RunOutcome {
  onResult(result: SandboxResult): void;
  onFault(fault: ModuleFault): void;
  /** After one of the two; the next run may start. */
  onEnd(): void;
  /** In place of the others: the sandbox went away under the run. */
  onLost(): void;
}

/** Runs a sandbox, one run at a time. [PM-10] */
export class Runner {
  readonly #clock: Clock;
  #sandbox: Sandbox | undefined;
  #isBusy = false;
  #lastStartMs: number | undefined;
  #idleWaiters: (() => void)[] = [];

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  get isBusy(): boolean {
    return this.#isBusy;
  }

  get lastStartMs(): number | undefined {
    return this.#lastStartMs;
  }

  /** Runs this one from now on. Its first run is the first. */
  attach(sandbox: Sandbox): void {
    this.#sandbox = sandbox;
    this.#lastStartMs = undefined;
  }

  /** Forgets the sandbox and the run under way. */
  detach(): void {
    this.#sandbox = undefined;
    this.#handleIdle();
  }

  /** Starts a run. Only while none is under way. */
  start(call: RunCall, outcome: RunOutcome): void {
    const sandbox = this.#sandbox;
    if (sandbox === undefined || this.#isBusy) throw new Error('the module cannot run now');
    const startMs = this.#clock.monotonicMs();
    const { inputs, triggers } = call;
    const deltaTimeMs = call.deltaTimeMs ?? startMs - (this.#lastStartMs ?? startMs);
    this.#lastStartMs = startMs;
    this.#isBusy = true;
    sandbox
      .run({ deltaTimeMs, masterTimeMs: this.#clock.nowMs(), inputs, triggers })
      .then(
        (result) => {
          if (sandbox !== this.#sandbox) return outcome.onLost();
          outcome.onResult(result);
          this.#handleEnd(outcome);
        },
        (reason: unknown) => this.#handleFailure(sandbox, reason, outcome),
      )
      // The receiver of the outputs failed: end the instance, not the node.
      .catch((reason: unknown) => this.#handleFailure(sandbox, reason, outcome));
  }

  /** Resolves when no run is under way. */
  whenIdle(): Promise<void> {
    if (!this.#isBusy) return Promise.resolve();
    return new Promise((resolve) => this.#idleWaiters.push(resolve));
  }

  #handleFailure(sandbox: Sandbox, reason: unknown, outcome: RunOutcome): void {
    if (sandbox !== this.#sandbox) return outcome.onLost();
    outcome.onFault(toFault(reason, 'onProcessing'));
    this.#handleEnd(outcome);
  }

  #handleEnd(outcome: RunOutcome): void {
    this.#handleIdle();
    outcome.onEnd();
  }

  #handleIdle(): void {
    this.#isBusy = false;
    const waiters = this.#idleWaiters;
    if (waiters.length === 0) return;
    this.#idleWaiters = [];
    for (const resolve of waiters) resolve();
  }
}
