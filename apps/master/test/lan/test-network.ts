import { execFile, execFileSync, spawn } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { temporaryFolder } from '@ubii/program/testing';

/** Addresses that exist in the network of the test alone. */
export const MASTER = '10.203.0.1';
export const PHONE = '10.203.0.2';
export const OLD_DEVICE = '10.203.0.3';
export const MASTER_V6 = 'fd00:203::1';
export const PHONE_V6 = 'fd00:203::2';
/** More addresses of the machine that has the phone. */
export const NEIGHBOURS = Array.from({ length: 12 }, (_, i) => `10.203.0.${10 + i}`);

/** Two machines with a cable between them, and with nothing else: network namespaces of this test. */
export class TestNetwork {
  readonly #master = `ubii-m-${process.pid}`;
  readonly #phone = `ubii-p-${process.pid}`;
  readonly #removals: (() => void)[] = [];

  /** Why there can be none here; undefined: there can. */
  static reasonAgainst(): string | undefined {
    if (process.platform !== 'linux') return 'network namespaces are of Linux';
    if (process.getuid?.() !== 0) return 'making network namespaces takes root';
    const probe = `ubii-probe-${process.pid}`;
    try {
      execFileSync('ip', ['netns', 'add', probe], { stdio: 'pipe' });
      execFileSync('ip', ['netns', 'del', probe], { stdio: 'pipe' });
      return undefined;
    } catch (error) {
      return `"ip netns add" failed: ${String((error as Error).message).split('\n')[0]}`;
    }
  }

  open(): void {
    const cable = `uv${process.pid}`.slice(0, 13);
    const ends = [`${cable}a`, `${cable}b`] as const;
    for (const name of [this.#master, this.#phone]) ip('netns', 'add', name);
    ip('link', 'add', ends[0], 'type', 'veth', 'peer', 'name', ends[1]);
    const sides = [
      [this.#master, ends[0], [`${MASTER}/24`, `${MASTER_V6}/64`]],
      [
        this.#phone,
        ends[1],
        [PHONE, OLD_DEVICE, ...NEIGHBOURS].map((each) => `${each}/24`).concat(`${PHONE_V6}/64`),
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
    for (const [name, device] of sides) waitUntilSettled(name, device);
  }

  /** A folder until the network closes. */
  newFolder(): string {
    return temporaryFolder((remove) => this.#removals.push(remove));
  }

  close(): void {
    for (const remove of this.#removals) remove();
    for (const name of [this.#master, this.#phone]) {
      try {
        ip('netns', 'del', name);
      } catch {
        // It was not made.
      }
    }
  }

  /** Prefix of a command that runs on one of the machines; it is replaced by the program itself. */
  enter(where: 'master' | 'phone'): readonly string[] {
    return ['ip', 'netns', 'exec', where === 'master' ? this.#master : this.#phone];
  }

  /**
   * Starts a program of the machine that has the master.
   *
   * @param descriptors how many it may have open; as many as the test, when undefined
   */
  startOnMaster(
    args: readonly string[],
    env: NodeJS.ProcessEnv,
    descriptors?: number,
  ): ChildProcess {
    const limit = descriptors === undefined ? 'true' : `ulimit -n ${descriptors}`;
    return this.#start('master', ['sh', '-c', `${limit}; exec "$@"`, 'sh'], args, env);
  }

  /** Starts a program of the machine that has the phone. */
  startOnPhone(args: readonly string[]): ChildProcess {
    return this.#start('phone', [], args, process.env);
  }

  #start(
    where: 'master' | 'phone',
    before: readonly string[],
    args: readonly string[],
    env: NodeJS.ProcessEnv,
  ): ChildProcess {
    const [program = '', ...words] = this.enter(where);
    const command = [...words, ...before, process.execPath, ...args];
    return spawn(program, command, { stdio: ['ignore', 'pipe', 'pipe'], env });
  }

  /** Runs a script, with what it is to do as JSON, and reads the JSON it prints. */
  run(where: 'master' | 'phone', script: string, input: unknown): Promise<unknown> {
    const [program = '', ...words] = this.enter(where);
    const args = [...words, process.execPath, script, JSON.stringify(input)];
    return new Promise((resolve, reject) => {
      execFile(program, args, (error, stdout, stderr) => {
        if (error === null) resolve(JSON.parse(stdout));
        else reject(new Error(`${error.message}\n${stderr}`));
      });
    });
  }
}

/** Time for the system to finish with a new cable, milliseconds. */
const SETTLED_MS = 10_000;
const LOOK_MS = 50;

/**
 * The system works on a cable after it is up: it notices the other end, and tries out a link-local address for one to two
 * seconds. Browsers end what they load at each such change (`ERR_NETWORK_CHANGED`).
 */
function waitUntilSettled(name: string, device: string): void {
  const endMs = performance.now() + SETTLED_MS;
  const sleeper = new Int32Array(new SharedArrayBuffer(4));
  while (performance.now() < endMs) {
    const shown = ip('-n', name, 'addr', 'show', 'dev', device);
    const isUp = shown.includes('state UP');
    if (isUp && shown.includes('inet6 fe80:') && !shown.includes('tentative')) return;
    Atomics.wait(sleeper, 0, 0, LOOK_MS);
  }
}

function ip(...args: readonly string[]): string {
  return execFileSync('ip', args, { stdio: 'pipe', encoding: 'utf8' });
}
