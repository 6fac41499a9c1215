import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import type { Socket } from 'node:net';
import { fileURLToPath } from 'node:url';

import { dialLoopback } from '@ubii/harness';

/** Addresses of a network that exists for the attacks alone. */
export const MASTER_V4 = '10.205.0.1';
export const MASTER_V6 = 'fd00:205::1';
const OUTSIDERS = 48;

/** Addresses of those outside, one machine with many: as many phones as there are. */
export const OUTSIDE_V4: readonly string[] = Array.from(
  { length: OUTSIDERS },
  (_, index) => `10.205.0.${index + 2}`,
);
/** All of one network of 64 bits. */
export const OUTSIDE_V6: readonly string[] = Array.from(
  { length: OUTSIDERS },
  (_, index) => `fd00:205::${(index + 2).toString(16)}`,
);

/** Two network namespaces with a cable between them, and with nothing else. */
export class AttackNetwork {
  /** Network namespace of the master and this machine's own programs. */
  readonly inside = `ubii-in-${process.pid}`;
  readonly outside = `ubii-out-${process.pid}`;

  /** Why there can be none here; undefined: there can. */
  static reasonAgainst(): string | undefined {
    if (process.platform !== 'linux') return 'network namespaces are of Linux';
    if (process.getuid?.() !== 0) return 'making network namespaces takes root';
    const probe = `ubii-probe-${process.pid}`;
    try {
      ip('netns', 'add', probe);
      ip('netns', 'del', probe);
      return undefined;
    } catch (error) {
      return `"ip netns add" failed: ${String((error as Error).message).split('\n')[0]}`;
    }
  }

  open(): void {
    const cable = `ua${process.pid}`.slice(0, 13);
    const ends = [`${cable}a`, `${cable}b`] as const;
    for (const name of [this.inside, this.outside]) ip('netns', 'add', name);
    ip('link', 'add', ends[0], 'type', 'veth', 'peer', 'name', ends[1]);
    const sides = [
      [this.inside, ends[0], [`${MASTER_V4}/16`, `${MASTER_V6}/64`]],
      [
        this.outside,
        ends[1],
        [...OUTSIDE_V4.map((one) => `${one}/16`), ...OUTSIDE_V6.map((one) => `${one}/64`)],
      ],
    ] as const;
    for (const [name, device, addresses] of sides) {
      ip('link', 'set', device, 'netns', name);
      for (const address of addresses) {
        const options = address.includes(':') ? ['nodad'] : [];
        ip('-n', name, 'addr', 'add', address, 'dev', device, ...options);
      }
      ip('-n', name, 'link', 'set', 'lo', 'up');
      ip('-n', name, 'link', 'set', device, 'up');
    }
  }

  close(): void {
    for (const name of [this.inside, this.outside]) {
      try {
        ip('netns', 'del', name);
      } catch {
        // It was not made.
      }
    }
  }
}

function ip(...args: readonly string[]): void {
  execFileSync('ip', args, { stdio: 'pipe' });
}

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

  /** @throws Error when the connection is refused */
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
