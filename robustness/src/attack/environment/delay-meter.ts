import { fork, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { fileURLToPath } from 'node:url';

const program = fileURLToPath(new URL('delay-process.ts', import.meta.url));

/** Milliseconds. */
export interface Delays {
  readonly p50: number;
  readonly p99: number;
}

/** Measures how long the master takes to answer, in a process that an attack does not slow down. */
export class DelayMeter {
  readonly #child: ChildProcess;

  private constructor(child: ChildProcess) {
    this.#child = child;
  }

  static async open(url: string): Promise<DelayMeter> {
    const child = fork(program, [url], { execArgv: ['--import', import.meta.resolve('tsx')] });
    await once(child, 'message');
    return new DelayMeter(child);
  }

  /** @returns delays of `GET /health`, and of records from one client of this machine to another */
  async during(durationMs: number): Promise<{ health: Delays; record: Delays }> {
    const answer = once(this.#child, 'message');
    this.#child.send(durationMs);
    const [{ health, record }] = (await answer) as [{ health: number[]; record: number[] }];
    return { health: delaysIn(health), record: delaysIn(record) };
  }

  close(): void {
    this.#child.kill('SIGKILL');
  }
}

function delaysIn(sorted: readonly number[]): Delays {
  const at = (part: number): number => sorted[Math.floor(part * (sorted.length - 1))]!;
  return { p50: at(0.5), p99: at(0.99) };
}
