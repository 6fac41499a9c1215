import { spawn, type ChildProcess } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { describeEnd } from '@ubii/harness';
import { decode, encode, type Init, type ServiceReply, type ServiceRequest } from '@ubii/proto';

import type { PoolCommands, PoolReply, PoolRequest } from './client-pool-process.ts';

const PROGRAM = fileURLToPath(new URL('./client-pool-process.ts', import.meta.url));

type Result<C extends keyof PoolCommands> = Awaited<ReturnType<PoolCommands[C]>>;

interface Pending {
  resolve(value: unknown): void;
  reject(error: Error): void;
}

/** Controls the process of a pool of clients. */
export class ClientPoolHandle {
  readonly #child: ChildProcess;
  readonly #pending = new Map<number, Pending>();
  #number = 0;
  #ending: string | undefined;

  /** @param within command that starts it elsewhere */
  constructor(within: readonly string[]) {
    const node = [process.execPath, '--import', import.meta.resolve('tsx'), PROGRAM];
    const [program, ...args] = [...within, ...node];
    this.#child = spawn(program!, args, { stdio: ['ignore', 'inherit', 'inherit', 'ipc'] });
    this.#child.on('message', ({ number, value, error }: PoolReply) => {
      const pending = this.#pending.get(number);
      this.#pending.delete(number);
      if (error === undefined) pending?.resolve(value);
      else pending?.reject(new Error(error));
    });
    // Sending to a process that is ending fails; `exit` reports the end.
    this.#child.on('error', () => undefined);
    this.#child.once('exit', (code, signal) => {
      this.#ending = `The process of the clients of a machine ${describeEnd(code, signal)}.`;
      for (const { reject } of this.#pending.values()) reject(new Error(this.#ending));
      this.#pending.clear();
    });
  }

  get pid(): number {
    return this.#child.pid!;
  }

  do<C extends keyof PoolCommands>(
    command: C,
    ...args: Parameters<PoolCommands[C]>
  ): Promise<Result<C>> {
    if (this.#ending !== undefined) return Promise.reject(new Error(this.#ending));
    this.#number += 1;
    const request: PoolRequest = { number: this.#number, command, args };
    return new Promise<unknown>((resolve, reject) => {
      this.#pending.set(request.number, { resolve, reject });
      this.#child.send(request);
    }) as Promise<Result<C>>;
  }

  /** Calls a service of a master from the machine of this pool; an error is a reply as well. */
  async ask(url: string, request: Init<ServiceRequest>): Promise<ServiceReply> {
    const bytes = Buffer.from(encode('ubii.services.ServiceRequest', request));
    const reply = await this.do('ask', url, bytes.toString('base64'));
    return decode('ubii.services.ServiceReply', Buffer.from(reply, 'base64'));
  }

  close(): void {
    this.#child.kill('SIGKILL');
  }
}
