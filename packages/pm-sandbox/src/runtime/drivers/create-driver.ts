import type { Cancel } from '@ubii/timing';
import type { ModeDriver, RunHost } from './mode-driver.ts';
import type { ParsedMode } from '../../definition/parse-module.ts';
import { FrequencyDriver } from './frequency-driver.ts';
import { TriggerDriver, type InputMarks } from './trigger-driver.ts';

/** Runs again as soon as the run before ended and other work had a turn. [PM-28] */
class FreeDriver implements ModeDriver {
  readonly #host: RunHost;
  readonly #intervalMs: number;
  #isStarted = false;
  #cancel: Cancel | undefined;

  constructor(host: RunHost, maxHz: number) {
    this.#host = host;
    this.#intervalMs = 1000 / maxHz;
  }

  get waiting(): number {
    return 0;
  }

  start(): void {
    this.stop();
    this.#isStarted = true;
    if (!this.#host.isBusy) this.#wait();
  }

  stop(): void {
    this.#isStarted = false;
    this.#cancel?.();
    this.#cancel = undefined;
  }

  handleRunEnd(): void {
    if (this.#isStarted) this.#wait();
  }

  handleMark(): void {}

  #wait(): void {
    const { lastStartMs } = this.#host;
    const dueMs = lastStartMs === undefined ? 0 : lastStartMs + this.#intervalMs;
    this.#cancel?.();
    this.#cancel = this.#host.after(Math.max(0, dueMs - this.#host.monotonicMs()), this.#handleDue);
  }

  readonly #handleDue = (): void => {
    this.#cancel = undefined;
    if (!this.#host.isBusy) this.#host.run();
  };
}

/** In lockstep the session asks for each run. [PM-27] */
const LOCKSTEP_DRIVER: ModeDriver = {
  waiting: 0,
  start() {},
  stop() {},
  handleRunEnd() {},
  handleMark() {},
};

/** The driver of a mode. */
export function createDriver(
  mode: ParsedMode,
  host: RunHost,
  marks: InputMarks,
  maxFreeHz: number,
): ModeDriver {
  switch (mode.kind) {
    case 'frequency':
      return new FrequencyDriver(host, mode.hertz);
    case 'trigger':
      return new TriggerDriver(host, marks, mode);
    case 'free':
      return new FreeDriver(host, maxFreeHz);
    case 'lockstep':
      return LOCKSTEP_DRIVER;
  }
}
