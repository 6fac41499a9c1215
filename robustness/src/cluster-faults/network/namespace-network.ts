import { execFileSync } from 'node:child_process';
import { readdirSync } from 'node:fs';

import type { ClusterNetwork } from './cluster-network.ts';

const PREFIX = '10.206.0.';
const HUB_HOST = `${PREFIX}1`;
/** Last number of the address of the first master. */
const FIRST_HOST = 11;
/** Where `ip` lists namespaces. */
const NAMESPACES = '/run/netns';
/** Names of namespaces of this program: the digits are the id of the process that made them. */
const NAME = /^ubii-(?:hub|m\d+)-(\d+)p?$/;

/**
 * A network namespace for each master and its clients, and one with a bridge that connects them, in which NATS and the
 * program itself run. Nothing else is connected.
 */
export class NetworkNamespaces {
  readonly hub: string;
  readonly #tag: string;
  readonly #count: number;

  /** @param tag makes the names of this run unique: digits @param count number of masters */
  constructor(tag: string, count: number) {
    this.#tag = tag;
    this.#count = count;
    this.hub = `ubii-hub-${tag}`;
  }

  /** Why there can be none here; undefined: there can. */
  static reasonAgainst(): string | undefined {
    if (process.platform !== 'linux') return 'network namespaces are of Linux';
    if (process.getuid?.() !== 0) return 'making network namespaces takes root';
    const probe = new NetworkNamespaces(`${process.pid}p`, 1);
    try {
      probe.open();
      return undefined;
    } catch (error) {
      return `they cannot be made: ${String((error as Error).message).split('\n')[0]}`;
    } finally {
      probe.close();
    }
  }

  /** All networks of this program, also those of other runs. */
  static all(): readonly { readonly name: string; readonly owner: number }[] {
    if (process.platform !== 'linux') return [];
    try {
      return readdirSync(NAMESPACES).flatMap((name) => {
        const owner = NAME.exec(name)?.[1];
        return owner === undefined ? [] : [{ name, owner: Number(owner) }];
      });
    } catch {
      // There never was a namespace.
      return [];
    }
  }

  /** Removes a namespace, and kills what still runs in it. */
  static remove(name: string): void {
    try {
      const pids = execFileSync('ip', ['netns', 'pids', name], {
        encoding: 'utf8',
        stdio: 'pipe',
      });
      for (const pid of pids.split('\n').filter(Boolean)) process.kill(Number(pid), 'SIGKILL');
    } catch {
      // It has no network any more, or a process of it has just ended.
    }
    try {
      ip('netns', 'del', name);
    } catch {
      // It was not made.
    }
  }

  nameOf(index: number): string {
    return `ubii-m${index + 1}-${this.#tag}`;
  }

  open(): void {
    ip('netns', 'add', this.hub);
    inside(this.hub, 'link', 'set', 'lo', 'up');
    inside(this.hub, 'link', 'add', 'bridge', 'type', 'bridge');
    inside(this.hub, 'addr', 'add', `${HUB_HOST}/24`, 'dev', 'bridge');
    inside(this.hub, 'link', 'set', 'bridge', 'up');
    for (let index = 0; index < this.#count; index += 1) this.#connect(index);
  }

  close(): void {
    const names = Array.from({ length: this.#count }, (_, index) => this.nameOf(index));
    for (const name of [...names, this.hub]) NetworkNamespaces.remove(name);
  }

  #connect(index: number): void {
    const name = this.nameOf(index);
    const end = portOf(index);
    ip('netns', 'add', name);
    inside(name, 'link', 'set', 'lo', 'up');
    inside(this.hub, 'link', 'add', end, 'type', 'veth', 'peer', 'name', 'eth0', 'netns', name);
    inside(this.hub, 'link', 'set', end, 'master', 'bridge', 'up');
    inside(name, 'addr', 'add', `${hostOf(index)}/24`, 'dev', 'eth0');
    inside(name, 'link', 'set', 'eth0', 'up');
  }
}

/** The network between namespaces, for a program in the hub. */
export class NamespaceNetwork implements ClusterNetwork {
  readonly about = 'in network namespaces: a partition cuts a master and its clients off';
  readonly natsHost = HUB_HOST;
  readonly listenFlags = [];
  readonly #network: NetworkNamespaces;
  #natsPort = 0;

  constructor(network: NetworkNamespaces) {
    this.#network = network;
  }

  openLinks(natsPort: number): Promise<void> {
    this.#natsPort = natsPort;
    return Promise.resolve();
  }

  natsUrl(): string {
    return `nats://${HUB_HOST}:${this.#natsPort}`;
  }

  within(index: number): readonly string[] {
    return ['ip', 'netns', 'exec', this.#network.nameOf(index)];
  }

  hostOf(index: number): string {
    return hostOf(index);
  }

  cut(index: number): void {
    inside(this.#network.hub, 'link', 'set', portOf(index), 'down');
  }

  heal(index: number): void {
    inside(this.#network.hub, 'link', 'set', portOf(index), 'up');
  }

  close(): Promise<void> {
    return Promise.resolve();
  }
}

function hostOf(index: number): string {
  return `${PREFIX}${FIRST_HOST + index}`;
}

function portOf(index: number): string {
  return `m${index + 1}`;
}

function inside(namespace: string, ...args: readonly string[]): void {
  ip('-n', namespace, ...args);
}

function ip(...args: readonly string[]): void {
  execFileSync('ip', args, { stdio: 'pipe' });
}
