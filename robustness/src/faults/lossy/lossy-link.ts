import { execFileSync, spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { accessSync, constants } from 'node:fs';
import { createInterface, type Interface } from 'node:readline';
import { fileURLToPath } from 'node:url';

const PROGRAM = fileURLToPath(new URL('link.py', import.meta.url));
/** Addresses of a network that only the namespace of the link has. */
const NEAR = '10.206.0.1';
export const FAR = '10.206.0.2';

/** Loss and delay of packets on the link. */
export interface LinkQuality {
  /** Share of packets that are lost, 0 to 1. */
  readonly loss: number;
  /** Every packet is late by this, and by up to `jitterMs` more, milliseconds; so packets overtake one another. */
  readonly delayMs: number;
  readonly jitterMs: number;
}

export const GOOD_LINK: LinkQuality = { loss: 0, delayMs: 0, jitterMs: 0 };

/** A network namespace in which {@link FAR} is the namespace itself, over a link that loses packets. */
export class LossyLink {
  readonly #namespace: string;
  readonly #child: ChildProcess;
  readonly #lines: Interface;

  private constructor(namespace: string, child: ChildProcess, lines: Interface) {
    this.#namespace = namespace;
    this.#child = child;
    this.#lines = lines;
  }

  /** @returns why there can be no link here; undefined: there can */
  static reasonAgainst(): string | undefined {
    if (process.platform !== 'linux') return 'TUN devices and network namespaces are of Linux';
    if (process.getuid?.() !== 0) return 'making network namespaces takes root';
    try {
      accessSync('/dev/net/tun', constants.R_OK | constants.W_OK);
      execFileSync('python3', ['--version'], { stdio: 'ignore' });
      execFileSync('ip', ['-V'], { stdio: 'ignore' });
      return undefined;
    } catch (error) {
      return `it takes /dev/net/tun, python3 and ip: ${String((error as Error).message)}`;
    }
  }

  static async open(): Promise<LossyLink> {
    const namespace = `ubii-lossy-${process.pid}`;
    ip('netns', 'add', namespace);
    const child = spawn('ip', ['netns', 'exec', namespace, 'python3', PROGRAM, NEAR, FAR], {
      stdio: ['pipe', 'pipe', 'inherit'],
    });
    const lines = createInterface({ input: child.stdout! });
    const link = new LossyLink(namespace, child, lines);
    try {
      await link.#nextLine();
      return link;
    } catch (error) {
      await link.close();
      throw error;
    }
  }

  /** Words of a command that start a program within the namespace. */
  get within(): readonly string[] {
    return ['ip', 'netns', 'exec', this.#namespace];
  }

  set(quality: LinkQuality): void {
    this.#child.stdin!.write(`${JSON.stringify(quality)}\n`);
  }

  /** Removes the link. @returns packets that it passed on and that it lost */
  async close(): Promise<{ passed: number; lost: number }> {
    let counts = { passed: 0, lost: 0 };
    if (this.#child.exitCode === null) {
      const line = this.#nextLine();
      this.#child.stdin!.end();
      counts = JSON.parse(await line) as typeof counts;
    }
    ip('netns', 'del', this.#namespace);
    return counts;
  }

  async #nextLine(): Promise<string> {
    const ended = once(this.#child, 'exit').then(([code]) => {
      throw new Error(`The link ended with ${code}.`);
    });
    const [line] = (await Promise.race([once(this.#lines, 'line'), ended])) as [string];
    return line;
  }
}

function ip(...words: string[]): void {
  execFileSync('ip', words, { stdio: ['ignore', 'ignore', 'pipe'] });
}
