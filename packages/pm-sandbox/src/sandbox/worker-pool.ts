import type { SandboxFactory, SandboxRequest } from '../ports/sandbox.ts';
import { sourceTooLong } from '../worker/check-source.ts';
import { moduleFault } from '../worker/module-error.ts';
import type { WorkerKind } from '../worker/protocol.ts';
import { PoolMemory } from './pool-memory.ts';
import { RemoteSandbox } from './remote-sandbox.ts';
import { WorkerHost } from './worker-host.ts';
import type { PoolOptions, PoolPlatform } from './worker-link.ts';

/** Instances that are remembered for having had their worker ended. */
const MAX_CULPRITS = 256;

/**
 * Sandboxes in a pool of workers. Workers start when they are needed; many instances share them. An
 * instance whose worker had to be ended gets one of its own the next time. [PM-50]
 */
export function createPooledSandboxes(
  platform: PoolPlatform,
  options: PoolOptions,
): SandboxFactory {
  const memory = new PoolMemory(options.memory);
  const pool = new WorkerPool(platform, options, memory);
  return {
    memory,
    open: (request, events) =>
      new RemoteSandbox(
        request,
        events,
        () => pool.place(request),
        (host) => pool.release(host),
      ),
    async check(source) {
      const tooLong = sourceTooLong(source);
      if (tooLong !== undefined) return tooLong;
      try {
        return await pool.shared('sandboxed').check(source);
      } catch (fault) {
        return fault as ReturnType<typeof sourceTooLong>;
      }
    },
    close() {
      pool.close();
      return Promise.resolve();
    },
  };
}

/**
 * Modules of one group share workers. Modules with asset sets compute for tens of milliseconds at a time, in which every other module of
 * their worker waits: they share theirs among themselves.
 */
type WorkerGroup = WorkerKind | 'assets';

class WorkerPool {
  readonly #platform: PoolPlatform;
  readonly #options: PoolOptions;
  readonly #hosts = new Map<WorkerHost, WorkerGroup>();
  readonly #culprits = new Set<string>();

  readonly #memory: PoolMemory;

  constructor(platform: PoolPlatform, options: PoolOptions, memory: PoolMemory) {
    this.#memory = memory;
    this.#platform = platform;
    this.#options = options;
  }

  place(request: SandboxRequest): WorkerHost {
    const group = groupOf(request);
    return this.#culprits.has(request.instanceId) ? this.#start(group, true) : this.shared(group);
  }

  /** The worker with the fewest instances; a new one as long as there may be more. */
  shared(group: WorkerGroup): WorkerHost {
    const hosts = this.#sharedOf(group);
    const least = hosts.reduce<WorkerHost | undefined>(
      (best, host) => (best === undefined || host.load < best.load ? host : best),
      undefined,
    );
    const isEnough = least?.load === 0 || hosts.length >= this.#options.maxWorkers;
    return least !== undefined && isEnough ? least : this.#start(group, false);
  }

  /** Ends an unused worker; the last of its group is kept for the next instance. */
  release(host: WorkerHost): void {
    const group = this.#hosts.get(host);
    if (!host.isIdle || group === undefined) return;
    if (host.isSolo || this.#sharedOf(group).length > 1) {
      host.end(moduleFault('crashed', '', 'The worker is not needed any more.'));
    }
  }

  close(): void {
    for (const host of [...this.#hosts.keys()]) {
      host.end(moduleFault('crashed', '', 'The node is closing.'));
    }
  }

  #start(group: WorkerGroup, isSolo: boolean): WorkerHost {
    const host = new WorkerHost(
      group === 'assets' ? 'trusted' : group,
      isSolo,
      this.#platform,
      this.#options,
      this.#memory,
      (culprit) => {
        this.#hosts.delete(host);
        if (culprit !== undefined) this.#remember(culprit.instanceId);
      },
    );
    this.#hosts.set(host, group);
    return host;
  }

  #remember(instanceId: string): void {
    const [oldest] = this.#culprits;
    if (this.#culprits.size >= MAX_CULPRITS && oldest !== undefined) this.#culprits.delete(oldest);
    this.#culprits.add(instanceId);
  }

  #sharedOf(group: WorkerGroup): WorkerHost[] {
    return [...this.#hosts].flatMap(([host, own]) => (own === group && !host.isSolo ? [host] : []));
  }
}

function groupOf({ isTrusted, assets }: SandboxRequest): WorkerGroup {
  if (!isTrusted) return 'sandboxed';
  return assets.length > 0 ? 'assets' : 'trusted';
}
