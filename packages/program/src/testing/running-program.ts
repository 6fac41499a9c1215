import { spawn } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { onTestFinished } from 'vitest';
import { temporaryFolder } from './temporary-folder.ts';

/** A program of Node.js that runs, and its output. It is killed when the test ends. */
export class RunningProgram {
  readonly child: ChildProcess;
  stdout = '';
  stderr = '';
  readonly #watchers = new Set<() => void>();

  constructor(
    file: string,
    flags: readonly string[],
    { withChannel = false, env = {} }: { withChannel?: boolean; env?: Record<string, string> } = {},
  ) {
    this.child = spawn(process.execPath, [file, ...flags], {
      stdio: ['ignore', 'pipe', 'pipe', ...(withChannel ? (['ipc'] as const) : [])],
      env: { PATH: process.env['PATH'], HOME: temporaryFolder(), ...env },
    });
    this.child.stdout?.on('data', (text) => {
      this.stdout += text;
      for (const watch of [...this.#watchers]) watch();
    });
    this.child.stderr?.on('data', (text) => {
      this.stderr += text;
      for (const watch of [...this.#watchers]) watch();
    });
    for (const event of ['exit', 'close']) {
      this.child.once(event, () => {
        for (const watch of [...this.#watchers]) watch();
      });
    }
    onTestFinished(() => this.kill());
  }

  /** Resolves with the exit code when the process has ended. */
  async ended(): Promise<number | null> {
    await this.#until(() => (this.#isOver ? true : undefined));
    return this.child.exitCode;
  }

  get #isOver(): boolean {
    return this.child.exitCode !== null || this.child.signalCode !== null;
  }

  /** Resolves with the line of `--print-endpoints json`. */
  async ready<T>(): Promise<T> {
    await this.#until(() => (this.stdout.includes('\n') ? true : undefined));
    return JSON.parse(this.stdout) as T;
  }

  /** Resolves when the program has logged the text. */
  async says(text: string | RegExp): Promise<void> {
    const fits =
      typeof text === 'string' ? (all: string) => all.includes(text) : text.test.bind(text);
    await this.#until(() => (fits(this.stderr) ? true : undefined));
  }

  /** Kills the process, as in a crash. */
  async kill(): Promise<void> {
    if (this.#isOver) return;
    const gone = new Promise((resolve) => this.child.once('exit', resolve));
    this.child.kill('SIGKILL');
    await gone;
  }

  #until<T>(read: () => T | undefined): Promise<T> {
    return new Promise((resolve, reject) => {
      const watch = (): void => {
        const found = read();
        if (found !== undefined) resolve(found);
        else if (!this.#isOver) return;
        else
          reject(new Error(`The program exited with code ${this.child.exitCode}: ${this.stderr}`));
        this.#watchers.delete(watch);
      };
      this.#watchers.add(watch);
      watch();
    });
  }
}
