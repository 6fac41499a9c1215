import { spawn, type ChildProcess } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { describeEnd } from '@ubii/harness';
import { decode, encode, type Init, type ServiceReply, type ServiceRequest } from '@ubii/proto';

import type { CrowdCommands, CrowdReply, CrowdRequest } from './crowd-process.ts';

const PROGRAM = fileURLToPath(new URL('./crowd-process.ts', import.meta.url));

type Result<C extends keyof CrowdCommands> = Awaited<ReturnType<CrowdCommands[C]>>;

interface Pending {
  resolve(value: unknown): void;
  reject(error: Error): void;
}

/** A crowd process, as the program that leads sees it. */
export class CrowdHandle {
  readonly #child: ChildProcess;
  readonly #pending = new Map<number, Pending>();
  #number = 0;
  #ending: string | undefined;

  /** @param within words of the command that it is started by */
  constructor(within: readonly string[]) {
    const node = [process.execPath, '--import', import.meta.resolve('tsx'), PROGRAM];
    const [program, ...args] = [...within, ...node];
    this.#child = spawn(program!, args, { stdio: ['ignore', 'inherit', 'inherit', 'ipc'] });
    this.#child.on('message', ({ number, value, error }: CrowdReply) => {
      const pending = this.#pending.get(number);
      this.#pending.delete(number);
      if (error === undefined) pending?.resolve(value);
      else pending?.reject(new Error(error));
    });
    // A message to a process that is about to end; its end is told below.
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

  do<C extends keyof CrowdCommands>(
    command: C,
    ...args: Parameters<CrowdCommands[C]>
  ): Promise<Result<C>> {
    if (this.#ending !== undefined) return Promise.reject(new Error(this.#ending));
    this.#number += 1;
    const request: CrowdRequest = { number: this.#number, command, args };
    return new Promise<unknown>((resolve, reject) => {
      this.#pending.set(request.number, { resolve, reject });
      this.#child.send(request);
    }) as Promise<Result<C>>;
  }

  /** Calls a service of a master from the machine of this crowd; an error is a reply as well. */
  async ask(url: string, request: Init<ServiceRequest>): Promise<ServiceReply> {
    const bytes = Buffer.from(encode('ubii.services.ServiceRequest', request));
    const reply = await this.do('ask', url, bytes.toString('base64'));
    return decode('ubii.services.ServiceReply', Buffer.from(reply, 'base64'));
  }

  close(): void {
    this.#child.kill('SIGKILL');
  }
}
