import { createClient } from '@ubii/client-web/node';
import type {
  ClientOptions,
  ClientProblem,
  ConnectionState,
  UbiiClient,
} from '@ubii/client-web/node';
import { createMemoryServices, createMemoryTopicData } from '@ubii/client-web/testing';
import type { MemoryConnection, MemoryMaster, MemoryPeer } from '@ubii/client-web/testing';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { FakeClock } from '@ubii/timing/testing';
import type { CallerFacts, CallerStanding, Limits } from '../src/index.ts';
import { openMemoryChannel, TestMaster } from '../src/testing/index.ts';
import type { MemoryChannel, TestMasterOptions } from '../src/testing/index.ts';

/** Time passes in steps of this size, with a turn for promises after each, milliseconds. */
const STEP_MS = 50;

/** A client of the library, with what it reported so far. */
export interface WorldClient {
  readonly client: UbiiClient;
  readonly states: ConnectionState[];
  readonly problems: ClientProblem[];
}

/** A whole master and whole clients of our library in memory, on one clock. */
export class ClientWorld implements MemoryMaster {
  readonly clock = new FakeClock();
  /** While true, the master is not available. */
  isDown = false;
  /** The transport's classification of the callers. */
  standing: CallerStanding = 'trusted';
  readonly #options: Omit<TestMasterOptions, 'clock'>;
  #test: TestMaster;
  #runs = 0;
  readonly #open = new Set<{ peer: MemoryPeer; channel: MemoryChannel }>();

  constructor(limits: Partial<Limits> = {}, options: Omit<TestMasterOptions, 'clock'> = {}) {
    this.#options = { limits, ...options };
    this.#test = new TestMaster({ ...this.#options, clock: this.clock });
  }

  /** The master of this moment. */
  get test(): TestMaster {
    return this.#test;
  }

  /** A connected client. Waits for the connection, unless told otherwise. */
  async connect(name: string, options: Partial<ClientOptions> = {}): Promise<WorldClient> {
    const client = createClient({
      name,
      publishIntervalMs: 0,
      clock: this.clock,
      random: () => 0,
      transports: { services: createMemoryServices(this), topicData: createMemoryTopicData(this) },
      ...options,
    });
    const states: ConnectionState[] = [];
    const problems: ClientProblem[] = [];
    client.onState((state) => states.push(state));
    client.onError((problem) => problems.push(problem));
    const connected = client.connect();
    connected.catch(() => undefined);
    await this.pass(0);
    await connected;
    return { client, states, problems };
  }

  /** Lets time pass, for master and clients. */
  async pass(durationMs: number): Promise<void> {
    await settle();
    this.clock.advanceSync(0);
    await settle();
    for (let passedMs = 0; passedMs < durationMs; passedMs += STEP_MS) {
      this.clock.advanceSync(Math.min(STEP_MS, durationMs - passedMs));
      await settle();
    }
  }

  /** Breaks every link, as a network does. */
  async drop(): Promise<void> {
    for (const { peer, channel } of this.#open) {
      peer.close(1006, '');
      channel.handleClose();
    }
    this.#open.clear();
    await settle();
  }

  /** The master's process ends and another one starts with the same data directory. */
  async restart(): Promise<void> {
    await this.#test.master.close();
    await this.drop();
    this.#test = new TestMaster({
      ...this.#options,
      clock: this.clock,
      storage: this.#test.storage,
      grants: this.#test.grants,
      idsGiven: 1_000 * ++this.#runs,
    });
  }

  async handleServiceRequest(
    request: ServiceRequest,
    bearer?: string,
  ): Promise<Init<ServiceReply>> {
    if (this.isDown) throw new Error('the master is down');
    const { reply, afterReply } = await this.#test.master.handleServiceRequest(
      request,
      this.#callerWith(bearer),
    );
    void Promise.resolve().then(() => {
      afterReply();
      this.clock.endTurnSync();
    });
    return reply;
  }

  #callerWith(bearer: string | undefined): CallerFacts {
    const isHere = this.standing === 'trusted' || this.standing === 'local';
    return { standing: this.standing, isHere, place: '192.168.1.50', bearer };
  }

  openConnection(
    query: { clientId: string; resumeToken: string | undefined },
    peer: MemoryPeer,
  ): MemoryConnection | undefined {
    if (this.isDown) return undefined;
    const claim = { clientId: query.clientId, token: query.resumeToken };
    const dial = { claim, caller: this.#callerWith(undefined) };
    const channel = openMemoryChannel(this.#test.master, dial, peer);
    this.clock.endTurnSync();
    if (channel === undefined) return undefined;
    const open = { peer, channel };
    this.#open.add(open);
    return {
      handleBinary: (bytes) => {
        channel.handleBinary(bytes);
        this.clock.endTurnSync();
      },
      handleText: (text) => {
        channel.handleText(text);
        this.clock.endTurnSync();
      },
      handleClose: (code) => {
        this.#open.delete(open);
        channel.handleClose(code);
        this.clock.endTurnSync();
      },
    };
  }
}
