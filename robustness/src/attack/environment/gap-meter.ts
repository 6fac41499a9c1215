import { fork, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

const program = fileURLToPath(new URL('gap-process.ts', import.meta.url));
/** Time in which delayed records arrive. */
const CALM_MS = 1_500;

/** Publishes at 100 Hz in a process of its own, through the master, and measures the longest time without a record. */
export class GapMeter {
  readonly #child: ChildProcess;

  private constructor(child: ChildProcess) {
    this.#child = child;
  }

  static async open(url: string): Promise<GapMeter> {
    const child = fork(program, [url], { execArgv: ['--import', import.meta.resolve('tsx')] });
    await once(child, 'message');
    return new GapMeter(child);
  }

  /** The longest time without a record, beyond the 10 ms between two, while something is done and shortly after. */
  async during(action: () => Promise<unknown>): Promise<number> {
    await this.#ask('begin');
    await action();
    await new Promise((resolve) => setTimeout(resolve, CALM_MS));
    return this.#ask('read');
  }

  close(): void {
    this.#child.kill('SIGKILL');
  }

  async #ask(word: string): Promise<number> {
    const answer = once(this.#child, 'message');
    this.#child.send(word);
    return (await answer)[0] as number;
  }
}
