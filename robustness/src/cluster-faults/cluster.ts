import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { hasFlag, MasterProcess, mib, type NatsServer, startNats } from '@ubii/harness';
import { AccessRole, type Init, type ServiceReply, type ServiceRequest } from '@ubii/proto';

import { ClientPoolHandle } from './clients/client-pool-handle.ts';
import type { ClusterNetwork } from './network/cluster-network.ts';
import { makeRunFolder } from './leftovers.ts';

/** Room for the clients of all masters, which come from one address each. */
const LIMITS =
  'connectionsPerAddress=9000,connectionsPerNetwork=9000,connectionsOfStrangers=9000,connections=18000';
const DAY_MS = 24 * 3_600_000;
/** Descriptors of a master, where the system gives so many. */
const DESCRIPTORS = 65_536;

/** Replies of a master whose store did not answer: what was asked may have been done. */
const UNKNOWN = 'unavailable';
/** What masters rightly report as an error while NATS is away. */
const WITHOUT_NATS = /NATS (?:cannot be reached|did not answer)/;

/** Several masters, their NATS server, and the clients on the machine of each. */
export class TestCluster {
  readonly network: ClusterNetwork;
  readonly nats: NatsServer;
  readonly pools: readonly ClientPoolHandle[];
  readonly #masters: MasterProcess[] = [];
  readonly #folder: string;
  readonly #cutOff = new Set<number>();

  private constructor(network: ClusterNetwork, nats: NatsServer, folder: string, count: number) {
    this.network = network;
    this.nats = nats;
    this.#folder = folder;
    this.pools = Array.from(
      { length: count },
      (_, index) => new ClientPoolHandle(network.within(index)),
    );
  }

  static async start(
    network: ClusterNetwork,
    count: number,
    { program, canOpenMore }: { program: string; canOpenMore: boolean },
  ): Promise<TestCluster> {
    const folder = makeRunFolder();
    const nats = await startNats({ jetstream: true, host: network.natsHost, parentFolder: folder });
    await network.openLinks(nats.port);
    const cluster = new TestCluster(network, nats, folder, count);
    try {
      for (let index = 0; index < count; index += 1) {
        const flags = ['--cluster', network.natsUrl(index), '--name', `master ${index + 1}`];
        // In network namespaces, NATS is at another address, which only the masters of the test reach.
        if (hasFlag(program, '--cluster-insecure')) flags.push('--cluster-insecure');
        const master = await MasterProcess.start({
          program,
          within: network.within(index),
          network: network.listenFlags,
          dataDir: join(folder, `data-${index + 1}`),
          flags: [...flags, '--limits', LIMITS],
          ...(canOpenMore && { maxDescriptors: DESCRIPTORS }),
        });
        cluster.#masters.push(master);
      }
    } catch (error) {
      await cluster.close();
      throw error;
    }
    return cluster;
  }

  get size(): number {
    return this.#masters.length;
  }

  /** Masters that run and can be reached. */
  get present(): number[] {
    return [...this.#masters.keys()].filter(
      (index) => this.#masters[index]!.isRunning && !this.#cutOff.has(index),
    );
  }

  /** Masters that do not run, with how they ended, in words. */
  ended(): string[] {
    return this.#masters.flatMap(({ ending }, index) =>
      ending === undefined ? [] : [`master ${index + 1} ${ending}`],
    );
  }

  /** Memory and time of processors of each master, in words. */
  figures(): string[] {
    return this.#masters.map((master, index) => {
      const { residentBytes, peakBytes, cpuMs } = master.figures();
      const cpu = cpuMs === undefined ? '?' : (cpuMs / 1000).toFixed(1);
      return `master ${index + 1}: ${mib(residentBytes)}, ${mib(peakBytes)} at most, ${cpu} s of processors since its start`;
    });
  }

  /** URL of a master for its clients. */
  urlOf(index: number): string {
    return `http://${this.network.hostOf(index)}:${this.#masters[index]!.port}`;
  }

  /** Which master has this URL. */
  indexOf(url: string): number {
    return this.#masters.findIndex((_, index) => new URL(this.urlOf(index)).host === hostOf(url));
  }

  /** URL of a master for programs of its own machine, which are admins. */
  ownUrlOf(index: number): string {
    return `http://127.0.0.1:${this.#masters[index]!.port}`;
  }

  /** Asks a master as its operator. @throws Error when it is not known whether it was done */
  async ask(index: number, request: Init<ServiceRequest>): Promise<ServiceReply> {
    const reply = await this.pools[index]!.ask(this.ownUrlOf(index), request);
    if (reply.error?.code === UNKNOWN) throw new Error(reply.error.message);
    return reply;
  }

  /** Metrics of a master, as `MasterProcess.metrics` reads them. */
  async metric(index: number, name: string): Promise<number> {
    const text = await this.pools[index]!.do('metrics', this.ownUrlOf(index));
    return Number(new RegExp(`^${name} (\\d+)$`, 'm').exec(text)?.[1] ?? Number.NaN);
  }

  /** Makes an invitation that all clients join with. */
  async invite(): Promise<string> {
    const { accessGrantCreated, error } = await this.ask(0, {
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: {
        role: AccessRole.ACCESS_ROLE_PARTICIPANT,
        label: 'pool',
        lifetimeMs: DAY_MS,
        stayMs: DAY_MS,
      },
    });
    if (accessGrantCreated === undefined) throw new Error(error?.message);
    return accessGrantCreated.token;
  }

  kill(index: number): Promise<void> {
    return this.#masters[index]!.kill();
  }

  stop(index: number): Promise<void> {
    return this.#masters[index]!.stop();
  }

  restart(index: number): Promise<void> {
    return this.#masters[index]!.restart();
  }

  cut(index: number): void {
    this.#cutOff.add(index);
    this.network.cut(index);
  }

  heal(index: number): void {
    this.network.heal(index);
    this.#cutOff.delete(index);
  }

  /** Lines that no fault may cause: exceptions, and errors but for those of NATS being away. */
  failures(): string[] {
    const failures = this.#masters.flatMap((master, index) =>
      master.failures
        .filter((line) => !WITHOUT_NATS.test(line))
        .map((line) => `master ${index + 1}: ${line}`),
    );
    return [...new Set(failures)];
  }

  async close(): Promise<void> {
    for (const pool of this.pools) pool.close();
    await Promise.all(this.#masters.map((master) => master.dispose()));
    await this.nats.stop();
    await this.network.close();
    rmSync(this.#folder, { recursive: true, force: true });
  }
}

function hostOf(url: string): string {
  return URL.canParse(url) ? new URL(url).host : '';
}
