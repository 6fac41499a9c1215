import { createClient } from '@ubii/client-web/node';
import type {
  ClientOptions,
  ClientProblem,
  ConnectionState,
  UbiiClient,
} from '@ubii/client-web/node';
import { createMemoryServices, createMemoryTopicData } from '@ubii/client-web/testing';
import { settle } from '@ubii/timing/testing';
import { FakeClock } from '@ubii/timing/testing';
import type { Limits } from '../src/index.ts';
import { TestMaster } from '../src/testing/index.ts';
import type { TestMasterOptions } from '../src/testing/index.ts';
import { MemoryMasterOf } from './memory-master-of.ts';

/** Time passes in steps of this size, with a turn for promises after each, milliseconds. */
const STEP_MS = 50;

/** A client of the library, with what it reported so far. */
export interface WorldClient {
  readonly client: UbiiClient;
  readonly states: ConnectionState[];
  readonly problems: ClientProblem[];
}

/** A whole master and whole clients of our library in memory, on one clock. */
export class ClientWorld extends MemoryMasterOf {
  readonly clock: FakeClock;
  readonly #options: Omit<TestMasterOptions, 'clock'>;
  #test: TestMaster;
  #runs = 0;

  constructor(limits: Partial<Limits> = {}, options: Omit<TestMasterOptions, 'clock'> = {}) {
    const clock = new FakeClock();
    super(() => this.#test, clock);
    this.clock = clock;
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
}
