import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { spawn, type ChildProcess } from 'node:child_process';
import { createInterface } from 'node:readline';

/** Finds a server program. Debian has such programs where only the PATH of root leads. */
export function findProgram(name: string): string | undefined {
  const folders = [...(process.env['PATH'] ?? '').split(delimiter), '/usr/sbin', '/usr/local/sbin'];
  const file = process.platform === 'win32' ? `${name}.exe` : name;
  return folders.map((folder) => join(folder, file)).find((path) => existsSync(path));
}

/** How a process ended, in words. */
export function describeEnd(code: number | null, signal: NodeJS.Signals | null): string {
  if (signal === 'SIGKILL') {
    return 'ended by SIGKILL, from a user or from a system without free memory (see dmesg)';
  }
  if (signal === 'SIGABRT') return 'ended by SIGABRT: its heap was full, or it gave itself up';
  return signal === null ? `ended with ${code}` : `ended by ${signal}`;
}

/** Returns whether the process has ended. */
function hasEnded(child: ChildProcess): boolean {
  return child.exitCode !== null || child.signalCode !== null;
}

/** Resolves when the process has ended. */
function whenEnded(child: ChildProcess): Promise<void> {
  if (hasEnded(child)) return Promise.resolve();
  return new Promise((resolve) => child.once('exit', () => resolve()));
}

/** Ends a process with a signal, and resolves when it has ended. */
export async function endProgram(child: ChildProcess, signal: NodeJS.Signals): Promise<void> {
  if (hasEnded(child)) return;
  const ended = whenEnded(child);
  child.kill(signal);
  await ended;
}

/**
 * Ends a process with SIGTERM, or with SIGKILL when it is still running after the time limit.
 *
 * @returns whether it ended within the time limit
 */
async function endWithin(child: ChildProcess, timeoutMs: number): Promise<boolean> {
  let isLate = false;
  const timer = setTimeout(() => {
    isLate = true;
    child.kill('SIGKILL');
  }, timeoutMs);
  await endProgram(child, 'SIGTERM');
  clearTimeout(timer);
  return !isLate;
}

/** A start on a busy machine takes seconds; past this the program hangs. */
const START_TIMEOUT_MS = 60_000;
/** Programs promise to stop within two seconds; a busy machine takes longer. */
const STOP_TIMEOUT_MS = 20_000;
/** Time limit of a cleanup, after which nobody asks why the program still runs. */
const END_TIMEOUT_MS = 10_000;
const MAX_KEPT_LINES = 20_000;
const SHOWN_LINES = 20;

/** A program to be started, which prints a line of JSON when it is ready. */
export interface ServerCommand {
  /** Subject of error messages, such as `The master`. */
  readonly name: string;
  /** Program and arguments. */
  readonly command: readonly string[];
  /** Default: that of this process. */
  readonly cwd?: string | undefined;
  /** Receives every line of standard error. Default: a new list */
  readonly log?: string[];
}

/** A program ended while it started. */
export class StartRefused extends Error {
  readonly exitCode: number | null;
  /** Standard error so far. */
  readonly output: string;

  constructor(name: string, exitCode: number | null, output: string) {
    super(`${name} ended with ${exitCode} while it started.\n${output}`);
    this.exitCode = exitCode;
    this.output = output;
  }
}

/**
 * A program as a process of its own, with its log. It ends with this process, however this process ends.
 */
export class ServerProcess {
  /** What it printed when it was ready. */
  readonly ready: Readonly<Record<string, unknown>>;
  readonly #name: string;
  readonly #child: ChildProcess;
  readonly #log: string[];

  private constructor(
    name: string,
    child: ChildProcess,
    ready: Readonly<Record<string, unknown>>,
    log: string[],
  ) {
    this.#name = name;
    this.#child = child;
    this.ready = ready;
    this.#log = log;
  }

  /**
   * Starts a program, and resolves when it is ready.
   *
   * @throws StartRefused when it ends instead
   * @throws Error when it cannot be started, or is not ready within a minute
   */
  static async start({ name, command, cwd, log = [] }: ServerCommand): Promise<ServerProcess> {
    const child = spawn(command[0]!, command.slice(1), {
      cwd,
      // Programs of this repository stop when the channel closes, also when this process is killed.
      stdio: ['ignore', 'pipe', 'pipe', 'ipc'],
      env: withoutSettings(process.env),
    });
    // A program that hangs does not notice the channel.
    const killWithThisProcess = (): void => void child.kill('SIGKILL');
    process.once('exit', killWithThisProcess);
    child.once('exit', () => process.off('exit', killWithThisProcess));
    createInterface({ input: child.stderr! }).on('line', (line) => {
      if (log.length < MAX_KEPT_LINES) log.push(line);
    });
    return new ServerProcess(name, child, await readReady(name, child, log), log);
  }

  get pid(): number {
    return this.#child.pid!;
  }

  get isRunning(): boolean {
    return !hasEnded(this.#child);
  }

  /** How it ended, in words; undefined while it runs. */
  get ending(): string | undefined {
    return this.isRunning ? undefined : describeEnd(this.#child.exitCode, this.#child.signalCode);
  }

  /** Lines of standard error so far. */
  get log(): readonly string[] {
    return this.#log;
  }

  /** Ends it without a warning, as a crash or a power cut does. */
  kill(): Promise<void> {
    return endProgram(this.#child, 'SIGKILL');
  }

  /**
   * Ends it in good order.
   *
   * @throws Error when it did not end in time and was killed
   */
  async stop(): Promise<void> {
    if (await endWithin(this.#child, STOP_TIMEOUT_MS)) return;
    throw new Error(`${this.#name} did not stop within ${STOP_TIMEOUT_MS} ms.\n${tail(this.#log)}`);
  }

  /** Ends it in any case: one that does not stop is killed. */
  async end(): Promise<void> {
    await endWithin(this.#child, END_TIMEOUT_MS);
  }
}

function readReady(
  name: string,
  child: ChildProcess,
  log: readonly string[],
): Promise<Record<string, unknown>> {
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => {
      child.kill('SIGKILL');
      reject(new Error(`${name} did not start within ${START_TIMEOUT_MS} ms.\n${tail(log)}`));
    }, START_TIMEOUT_MS);
    createInterface({ input: child.stdout! }).on('line', (line) => {
      if (!line.startsWith('{')) return;
      clearTimeout(timer);
      resolve(JSON.parse(line) as Record<string, unknown>);
    });
    child.once('error', (error) => {
      clearTimeout(timer);
      reject(new Error(`${name} cannot be started: ${error.message}`));
    });
    child.once('close', (code) => {
      clearTimeout(timer);
      reject(new StartRefused(name, code, log.join('\n')));
    });
  });
}

/** Variables that configure programs of this repository belong to the user, not to the test. */
function withoutSettings(env: NodeJS.ProcessEnv): NodeJS.ProcessEnv {
  return Object.fromEntries(Object.entries(env).filter(([name]) => !name.startsWith('UBII_')));
}

function tail(log: readonly string[]): string {
  return log.slice(-SHOWN_LINES).join('\n');
}
