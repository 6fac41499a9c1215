import type { MemoryConnection, MemoryMaster, MemoryPeer } from '@ubii/client-web/testing';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { settle, type FakeClock } from '@ubii/timing/testing';
import type { CallerFacts, CallerStanding } from '../src/index.ts';
import { openMemoryChannel, type MemoryChannel, type TestMaster } from '../src/testing/index.ts';

/** A master in memory, as clients of our library reach it. */
export class MemoryMasterOf implements MemoryMaster {
  /** While true, the master is not available. */
  isDown = false;
  /** The transport's classification of the callers. */
  standing: CallerStanding = 'trusted';
  /** The address of the callers. */
  place = '192.168.1.50';
  readonly #test: () => TestMaster;
  readonly #clock: FakeClock;
  readonly #open = new Set<{ peer: MemoryPeer; channel: MemoryChannel }>();

  /** @param test the master of this moment */
  constructor(test: () => TestMaster, clock: FakeClock) {
    this.#test = test;
    this.#clock = clock;
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

  /** Ends at once, without telling clients or masters. */
  async die(): Promise<void> {
    this.isDown = true;
    await this.drop();
  }

  async handleServiceRequest(
    request: ServiceRequest,
    bearer?: string,
  ): Promise<Init<ServiceReply>> {
    if (this.isDown) throw new Error('the master is down');
    const { reply, afterReply } = await this.#test().master.handleServiceRequest(
      request,
      this.#callerWith(bearer),
    );
    void Promise.resolve().then(() => {
      afterReply();
      this.#clock.endTurnSync();
    });
    return reply;
  }

  openConnection(
    query: { clientId: string; resumeToken: string | undefined; sentMs?: number | undefined },
    peer: MemoryPeer,
  ): MemoryConnection | undefined {
    if (this.isDown) return undefined;
    const { clientId, resumeToken: token, sentMs } = query;
    const claim = { clientId, token, sentMs };
    const dial = { claim, caller: this.#callerWith(undefined) };
    const channel = openMemoryChannel(this.#test().master, dial, peer);
    this.#clock.endTurnSync();
    if (channel === undefined) return undefined;
    const open = { peer, channel };
    this.#open.add(open);
    return {
      handleBinary: (bytes) => {
        channel.handleBinary(bytes);
        this.#clock.endTurnSync();
      },
      handleText: (text) => {
        channel.handleText(text);
        this.#clock.endTurnSync();
      },
      handleClose: (code) => {
        this.#open.delete(open);
        channel.handleClose(code);
        this.#clock.endTurnSync();
      },
    };
  }

  #callerWith(bearer: string | undefined): CallerFacts {
    const isHere = this.standing === 'trusted' || this.standing === 'local';
    return { standing: this.standing, isHere, place: this.place, bearer };
  }
}
