import type { Cancel, TurnTask } from '@ubii/timing';
import type { ModeDriver, RunHost } from './mode-driver.ts';

/** The marks of an instance's inputs. */
export interface InputMarks {
  /** Marks the inputs that have a value, and only these. [PM-26] */
  markValues(): void;
  /** Whether any input is marked, or all that wait for topics. [PM-23] */
  isDue(allInputsNeedUpdate: boolean): boolean;
  /** Clears the marks, except of inputs with more than one event. Returns the names of the inputs that had one. */
  takeMarks(): string[];
}

interface TriggerOptions {
  readonly minDelayMs: number;
  readonly allInputsNeedUpdate: boolean;
}

/** Runs when inputs were updated. [PM-23] to [PM-26] */
export class TriggerDriver implements ModeDriver, TurnTask {
  readonly #host: RunHost;
  readonly #marks: InputMarks;
  readonly #options: TriggerOptions;
  #isStarted = false;
  #isAwaitingTurn = false;
  #isDue = false;
  #cancelDelay: Cancel | undefined;

  constructor(host: RunHost, marks: InputMarks, options: TriggerOptions) {
    this.#host = host;
    this.#marks = marks;
    this.#options = options;
  }

  get waiting(): number {
    return this.#isDue ? 1 : 0;
  }

  start(): void {
    this.stop();
    this.#isStarted = true;
    this.#marks.markValues();
    this.handleMark();
  }

  stop(): void {
    this.#isStarted = false;
    this.#isDue = false;
    this.#endDelay();
  }

  // [PM-25]
  handleRunEnd(): void {
    if (this.#isDue) this.#tryRun();
  }

  handleMark(): void {
    if (!this.#isStarted || this.#isAwaitingTurn) return;
    this.#isAwaitingTurn = true;
    this.#host.atEndOfTurn(this);
  }

  handleEndOfTurn(): void {
    this.#isAwaitingTurn = false;
    if (!this.#isStarted || !this.#marks.isDue(this.#options.allInputsNeedUpdate)) return;
    this.#isDue = true;
    this.#tryRun();
  }

  #tryRun(): void {
    if (this.#host.isBusy || this.#cancelDelay !== undefined) return;
    const delayMs = this.#delayMs();
    if (delayMs > 0) {
      // [PM-24]
      this.#cancelDelay = this.#host.after(delayMs, this.#handleDelayEnd);
      return;
    }
    this.#run();
  }

  readonly #handleDelayEnd = (): void => {
    this.#cancelDelay = undefined;
    if (this.#isDue && !this.#host.isBusy) this.#run();
  };

  #run(): void {
    const names = this.#marks.takeMarks();
    this.#isDue = this.#marks.isDue(this.#options.allInputsNeedUpdate);
    this.#host.run(names);
  }

  #delayMs(): number {
    const { lastStartMs } = this.#host;
    if (lastStartMs === undefined) return 0;
    return lastStartMs + this.#options.minDelayMs - this.#host.monotonicMs();
  }

  #endDelay(): void {
    this.#cancelDelay?.();
    this.#cancelDelay = undefined;
  }
}
