import { SERVICE_ERROR_CODES, SERVICES, type ServiceErrorCode } from '@ubii/proto';

/** Totals since the master started. Plain numbers, because the record path adds to them. */
export class Counters {
  /** Records received from clients and accepted. */
  recordsIn = 0;
  bytesIn = 0;
  /** Records handed to connections, once for each subscriber. */
  recordsOut = 0;
  bytesOut = 0;
  /** Records that other masters sent for subscribers of this one [CU-10]. */
  recordsFromMasters = 0;
  /** Records that were sent to other masters, once for each. */
  recordsToMasters = 0;
  /** Records that slow subscribers did not get [TD-34]. */
  dropped = 0;
  /** Records, requests and connections refused, by reason [TD-17]. */
  readonly refused: Record<ServiceErrorCode, number> = zeros(SERVICE_ERROR_CODES);
  /** Frames that could not be decoded, and text that is not of the protocol. */
  protocolErrors = 0;
  /** Requests by service; those for no service we know are `unknown`. */
  readonly requests = new Map<string, number>(
    [...Object.values(SERVICES).map((service) => service.topic), 'unknown'].map((topic) => [
      topic,
      0,
    ]),
  );
  /** Requests that were answered with an error. */
  failedRequests = 0;
  connectionsOpened = 0;
  connectionsRefused = 0;

  /** Everything refused, for whatever reason. */
  get refusedTotal(): number {
    return Object.values(this.refused).reduce((sum, count) => sum + count, 0);
  }

  countRequest(topic: string): void {
    const known = this.requests.has(topic) ? topic : 'unknown';
    this.requests.set(known, this.requests.get(known)! + 1);
  }
}

function zeros<K extends string>(keys: readonly K[]): Record<K, number> {
  return Object.fromEntries(keys.map((key) => [key, 0])) as Record<K, number>;
}
