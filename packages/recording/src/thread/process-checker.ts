import { fork, type ChildProcess } from 'node:child_process';
import { stat } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { ServiceError } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { recordingPath } from '../node/disk-folder.ts';
import type { CheckJob, FileChecker, Verdict } from '../recorder/file-checker.ts';
import type { RecorderLimits } from '../recorder/recorder-limits.ts';
import type { CheckLimits, FromChecker, ToChecker } from './check-messages.ts';

export interface ProcessCheckerOptions {
  /** The built process. */
  readonly processFile: URL;
  /** Path of the folder of the recordings. */
  readonly folder: string;
  readonly limits: CheckLimits & RecorderLimits;
  readonly clock: Clock;
}

const MIB = 1024 * 1024;
/** Bytes of a file for which a repair gets another millisecond: a slow SD card reads them in that time. */
const BYTES_PER_MS = 4 * 1024;
/** Time after which a process without work ends. */
const IDLE_MS = 5_000;

/** Is asked for one file at a time. */
interface Question {
  handle(message: FromChecker): void;
  /** @param how part of a sentence */
  handleEnd(how: string): void;
}

/**
 * Checks files in a process of its own: when one takes all its memory, or makes Node abort, nothing else ends. Threads cannot
 * contain an abort. [RC-44]
 */
export class ProcessChecker implements FileChecker {
  readonly #options: ProcessCheckerOptions;
  #process: ChildProcess | undefined = undefined;
  /** The same process, once it takes files. */
  #ready: ChildProcess | undefined = undefined;
  #question: Question | undefined = undefined;
  #queue: Promise<unknown> = Promise.resolve();
  #cancelIdle: Cancel = () => undefined;
  #isClosed = false;

  constructor(options: ProcessCheckerOptions) {
    this.#options = options;
  }

  check(job: CheckJob): Promise<Verdict> {
    const done = this.#queue.then(() => this.#check(job));
    this.#queue = done.catch(() => undefined);
    return done;
  }

  close(): Promise<void> {
    this.#isClosed = true;
    this.#cancelIdle();
    this.#end('the program ends');
    return Promise.resolve();
  }

  async #check(job: CheckJob): Promise<Verdict> {
    const timeMs = await this.#timeOf(job);
    this.#cancelIdle();
    try {
      return await this.#ask(job, timeMs);
    } finally {
      this.#cancelIdle = this.#options.clock.after(IDLE_MS, () => this.#end('it has no work'));
    }
  }

  #ask(job: CheckJob, timeMs: number): Promise<Verdict> {
    if (this.#isClosed) return Promise.reject(unavailable('The program ends.'));
    return new Promise((resolve, reject) => {
      let isAsked = false;
      let isLate = false;
      const cancelTime = this.#options.clock.after(timeMs, () => {
        isLate = true;
        this.#end('it took too long');
      });
      const finish = (settle: () => void): void => {
        cancelTime();
        this.#question = undefined;
        settle();
      };
      const child = (this.#process ??= this.#start());
      const ask = (): void => {
        isAsked = true;
        child.send(job satisfies ToChecker);
      };
      this.#question = {
        handle: (message) => {
          if (message.kind === 'ready') ask();
          else if (message.kind === 'verdict') finish(() => resolve(message.verdict));
          else finish(() => reject(unavailable(message.reason)));
        },
        handleEnd: (how) =>
          finish(() => {
            // A process that never began says nothing about the file.
            if (!isAsked || this.#isClosed) return reject(unavailable(`The check ended: ${how}.`));
            const reason = isLate ? tooSlow(timeMs) : this.#tooMuch(how);
            return resolve({ kind: 'unchecked', reason });
          }),
      };
      if (child === this.#ready) ask();
    });
  }

  #start(): ChildProcess {
    const { processFile, folder, limits } = this.#options;
    const heapMib = Math.floor(limits.recordingCheckBytes / MIB);
    const child = fork(fileURLToPath(processFile), [folder, JSON.stringify(limits)], {
      env: {},
      execArgv: [`--max-old-space-size=${heapMib}`],
      serialization: 'advanced',
      stdio: ['ignore', 'ignore', 'ignore', 'ipc'],
    });
    child.unref();
    child.channel?.unref();
    child.on('message', (message: FromChecker) => {
      if (this.#process !== child) return;
      if (message.kind === 'ready') this.#ready = child;
      this.#question?.handle(message);
    });
    const handleEnd = (how: string): void => {
      if (this.#process === child) this.#handleEnd(how);
    };
    child.on('error', (error) => handleEnd(error.message));
    child.on('exit', (code, signal) => handleEnd(`it ended with ${signal ?? `code ${code}`}`));
    return child;
  }

  #end(how: string): void {
    const child = this.#process;
    if (child === undefined) return;
    child.kill('SIGKILL');
    this.#handleEnd(how);
  }

  #handleEnd(how: string): void {
    this.#process = undefined;
    this.#ready = undefined;
    this.#question?.handleEnd(how);
  }

  #tooMuch(how: string): string {
    const mib = Math.floor(this.#options.limits.recordingCheckBytes / MIB);
    return `Its check did not come to an end with ${mib} MiB of memory: ${how}.`;
  }

  async #timeOf({ id, upload }: CheckJob): Promise<number> {
    const { folder, limits } = this.#options;
    if (upload !== undefined) return limits.recordingCheckMs;
    const size = await stat(recordingPath(folder, id)).then(
      (facts) => facts.size,
      () => 0,
    );
    return limits.recordingCheckMs + size / BYTES_PER_MS;
  }
}

function tooSlow(timeMs: number): string {
  return `Its check took longer than ${Math.round(timeMs / 1000)} s.`;
}

function unavailable(reason: string): ServiceError {
  return new ServiceError('unavailable', `The file could not be checked. ${reason} Try again.`);
}
