/** The side of a master that receives from the bus. No method throws. */
export interface BusListener {
  /** A message of another master. Takes over `message`: the bus does not modify it any more. */
  handleMessage(fromMasterId: string, message: Uint8Array): void;
  /** The bus can be reached, or no longer: what is sent meanwhile is lost. Called when that changes, and first when it can. */
  handleReach(isReachable: boolean): void;
}

/**
 * Carries messages between the masters of a cluster. Those of one master to another come in order and once; some
 * may be missing, when the bus was away or a receiver too slow. No method throws, whatever the state of the bus.
 */
export interface ClusterBus {
  /** Begins to receive what is sent to this master and to all. Called once. @param masterId a UUID, of this run */
  listen(masterId: string, listener: BusListener): void;
  /** Sends to one other master, a message of any size. Takes over `message`: it must not be modified any more. */
  send(toMasterId: string, message: Uint8Array): void;
  /** Sends to every other master. */
  broadcast(message: Uint8Array): void;
  /** Bytes that were sent and that the system has not taken yet. */
  readonly queuedBytes: number;
  /** Resolves after all messages have reached the bus and it is closed; at once when it is not reachable. */
  close(): Promise<void>;
}
