import { spawn, type ChildProcess } from 'node:child_process';
import type { Socket } from 'node:net';
import { fileURLToPath } from 'node:url';
import { dialLoopback } from '@ubii/harness';

const program = fileURLToPath(new URL('dial-process.mjs', import.meta.url));

/** Opens connections from the namespace of those outside; a connection stays there wherever it is used. */
export class Dialer {
  readonly #child: ChildProcess | undefined;
  readonly #waiting = new Map<number, (answer: Socket | Error) => void>();
  #last = 0;

  /** @param namespace undefined: there is none, connections are of this machine */
  constructor(namespace: string | undefined) {
    if (namespace === undefined) return;
    this.#child = spawn('ip', ['netns', 'exec', namespace, process.execPath, program], {
      stdio: ['ignore', 'inherit', 'inherit', 'ipc'],
    });
    this.#child.on('message', (message, handle) => {
      const { id, problem } = message as { id: number; problem?: string };
      const answer = handle === undefined ? new Error(problem ?? 'no socket') : (handle as Socket);
      this.#waiting.get(id)?.(answer);
      this.#waiting.delete(id);
    });
  }

  /** @throws Error when nobody takes the connection */
  async dial(host: string, port: number, from: string): Promise<Socket> {
    const child = this.#child;
    if (child === undefined) return dialLoopback(port);
    const id = ++this.#last;
    const answer = await new Promise<Socket | Error>((resolve) => {
      this.#waiting.set(id, resolve);
      child.send({ id, host, port, from });
    });
    if (answer instanceof Error) throw answer;
    answer.on('error', () => {});
    return answer;
  }

  close(): void {
    this.#child?.kill('SIGKILL');
  }
}
