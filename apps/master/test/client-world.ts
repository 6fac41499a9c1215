import { createClient } from '@ubii/client-web/node';
import type {
  ClientOptions,
  ClientProblem,
  ConnectionState,
  UbiiClient,
} from '@ubii/client-web/node';
import { createMemoryServices, createMemoryTopicData } from '@ubii/client-web/testing';
import type { MemoryConnection, MemoryMaster, MemoryPeer } from '@ubii/client-web/testing';
import { encodeErrorFrame, encodeRecordListFrame, recordFrameHeader } from '@ubii/proto/wire';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { settle } from '@ubii/timing/testing';
import { FakeClock } from '@ubii/timing/testing';
import type {
  CallerFacts,
  CallerStanding,
  ClientConnection,
  ConnectionHandle,
  Limits,
} from '../src/index.ts';
import { TestMaster, type TestMasterOptions } from '../src/testing/index.ts';

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
  readonly #open = new Set<{ peer: MemoryPeer; handle: ConnectionHandle }>();

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
    for (const { peer, handle } of this.#open) {
      peer.close(1006, '');
      handle.handleClose();
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
    const wanted = { clientId: query.clientId, token: query.resumeToken };
    const caller = this.#callerWith(undefined);
    // The edge refuses the upgrade: to a client, a link that never came up.
    if (this.#test.master.refuseConnection(wanted, caller) !== undefined) return undefined;
    const handle = this.#test.master.openConnection(wanted, new PeerConnection(peer), caller);
    this.clock.endTurnSync();
    if (handle === undefined) return undefined;
    const open = { peer, handle };
    this.#open.add(open);
    return {
      handleBinary: (bytes) => {
        handle.handleBinary(bytes);
        this.clock.endTurnSync();
      },
      handleText: (text) => {
        handle.handleText(text);
        this.clock.endTurnSync();
      },
      handleClose: () => {
        this.#open.delete(open);
        handle.handleClose();
        this.clock.endTurnSync();
      },
    };
  }
}

/** The master's end of a pipe in memory: what adapters/ws does over a WebSocket. */
class PeerConnection implements ClientConnection {
  readonly #peer: MemoryPeer;
  #takesLists = false;

  constructor(peer: MemoryPeer) {
    this.#peer = peer;
  }

  get queuedBytes(): number {
    return this.#peer.queuedBytes;
  }

  send({ records }: Parameters<ClientConnection['send']>[0]): void {
    if (this.#takesLists) {
      this.#peer.sendBinary(encodeRecordListFrame(records));
      return;
    }
    for (const record of records) {
      const header = recordFrameHeader(record.byteLength);
      const frame = new Uint8Array(header.byteLength + record.byteLength);
      frame.set(header);
      frame.set(record, header.byteLength);
      this.#peer.sendBinary(frame);
    }
  }

  sendError(error: Parameters<ClientConnection['sendError']>[0]): void {
    this.#peer.sendBinary(encodeErrorFrame(error));
  }

  sendFrame(frame: Uint8Array): void {
    this.#peer.sendBinary(frame);
  }

  sendPing(): void {
    this.#peer.sendText('PING');
  }

  sendPong(text = 'PONG'): void {
    this.#peer.sendText(text);
  }

  close(code: number, reason: string): void {
    this.#peer.close(code, reason);
  }

  setRecordLists(on: boolean): void {
    this.#takesLists = on;
  }
}
