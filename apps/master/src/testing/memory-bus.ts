import type { BusListener, ClusterBus } from '../core/ports/cluster-bus.ts';

/** What carries messages between masters in one process. Tests cut it, lose messages in it and take it away. */
export class MemoryHub {
  readonly #members = new Map<string, MemoryBus>();
  /** Pairs of masters that cannot reach one another. */
  readonly #cuts = new Set<string>();
  readonly #away = new Set<string>();
  #toLose = 0;
  #toCarry = 0;

  /** A bus for one more master. */
  bus(): MemoryBus {
    return new MemoryBus({
      join: (bus, masterId) => {
        this.#members.set(masterId, bus);
        queueMicrotask(() => bus.handleReach(!this.#away.has(masterId)));
      },
      leave: (masterId) => this.#members.delete(masterId),
      others: (masterId) => [...this.#members.keys()].filter((each) => each !== masterId),
      carry: (from, to, message) => this.#carry(from, to, message),
    });
  }

  /** From now on, these two masters get nothing of each other. The bus is reachable for both. */
  cut(masterA: string, masterB: string): void {
    this.#cuts.add(pairOf(masterA, masterB));
  }

  /** Undoes every cut. */
  heal(): void {
    this.#cuts.clear();
  }

  /**
   * Loses the next messages; one that is sent to several masters counts for each of them.
   *
   * @param after messages that are carried before
   */
  lose(count: number, after = 0): void {
    this.#toLose += count;
    this.#toCarry = after;
  }

  /** Loses nothing any more. */
  loseNothing(): void {
    this.#toLose = 0;
  }

  /** Takes the bus away from one master, or gives it back. */
  setReachable(masterId: string, isReachable: boolean): void {
    if (isReachable) this.#away.delete(masterId);
    else this.#away.add(masterId);
    queueMicrotask(() => this.#members.get(masterId)?.handleReach(!this.#away.has(masterId)));
  }

  #carry(from: string, to: string, message: Uint8Array): void {
    if (this.#isCut(from, to) || this.#isLost()) return;
    const copy = message.slice();
    queueMicrotask(() => {
      if (!this.#isCut(from, to)) this.#members.get(to)?.handleMessage(from, copy);
    });
  }

  #isCut(from: string, to: string): boolean {
    return this.#away.has(from) || this.#away.has(to) || this.#cuts.has(pairOf(from, to));
  }

  #isLost(): boolean {
    if (this.#toLose === 0) return false;
    if (this.#toCarry > 0) {
      this.#toCarry--;
      return false;
    }
    this.#toLose -= 1;
    return true;
  }
}

/** What a bus asks of its hub. */
interface HubSide {
  join(bus: MemoryBus, masterId: string): void;
  leave(masterId: string): void;
  others(masterId: string): readonly string[];
  carry(from: string, to: string, message: Uint8Array): void;
}

/** One master's side of a hub. Messages come in order, at the end of the turn in which they were sent. */
export class MemoryBus implements ClusterBus {
  /** Nothing waits in memory; a test may pretend that something does. */
  queuedBytes = 0;
  readonly #hub: HubSide;
  #listening: { readonly masterId: string; readonly listener: BusListener } | undefined;
  #wasReachable = false;

  constructor(hub: HubSide) {
    this.#hub = hub;
  }

  listen(masterId: string, listener: BusListener): void {
    this.#listening = { masterId, listener };
    this.#hub.join(this, masterId);
  }

  send(toMasterId: string, message: Uint8Array): void {
    const from = this.#listening?.masterId;
    if (from === undefined || toMasterId === from) return;
    this.#hub.carry(from, toMasterId, message);
  }

  broadcast(message: Uint8Array): void {
    const from = this.#listening?.masterId;
    if (from === undefined) return;
    for (const to of this.#hub.others(from)) this.#hub.carry(from, to, message);
  }

  close(): Promise<void> {
    const masterId = this.#listening?.masterId;
    this.#listening = undefined;
    if (masterId !== undefined) this.#hub.leave(masterId);
    // What was sent before is on its way by now.
    return Promise.resolve();
  }

  /** Of the hub: a message has come. */
  handleMessage(from: string, message: Uint8Array): void {
    this.#listening?.listener.handleMessage(from, message);
  }

  /** Of the hub: the bus may have come or gone. */
  handleReach(isReachable: boolean): void {
    if (isReachable === this.#wasReachable) return;
    this.#wasReachable = isReachable;
    this.#listening?.listener.handleReach(isReachable);
  }
}

function pairOf(masterA: string, masterB: string): string {
  return [masterA, masterB].sort().join(' ');
}
