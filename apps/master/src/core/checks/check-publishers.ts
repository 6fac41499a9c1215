import { StatusProblemSeverity } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { FoundProblem } from './findings.ts';

/**
 * Share of the master's thread that the records of a client take, percent [EX-47].
 * @param workPercent of the time in which the thread really computes
 */
export function threadPercentOf(client: Client, workPercent: number): number {
  return client.traffic.workShare * workPercent;
}

/** The key of what is found about a publisher. */
export function noisyKey(clientId: string): string {
  return `publisher_noisy ${clientId}`;
}

/** Clients that use more of the master than their share. [EX-47] */
export function* checkPublishers(
  clients: Iterable<Client>,
  workPercent: number,
  publisherPercent: number,
): Iterable<[key: string, FoundProblem]> {
  for (const client of clients) {
    const { recordsInPerSecond, throttledPerSecond } = client.traffic.rates;
    const percent = threadPercentOf(client, workPercent);
    // A client that only subscribes is not a publisher, whatever its cost.
    if (percent <= publisherPercent || recordsInPerSecond + throttledPerSecond === 0) continue;
    yield [
      noisyKey(client.id),
      {
        code: 'publisher_noisy',
        severity: StatusProblemSeverity.WARNING,
        text: `${client.label} publishes ${Math.round(recordsInPerSecond)} records per second, which take ${Math.round(percent)} % of the time of the master. All other clients share the rest.`,
        clientId: client.id,
        remedy: 'Publish less often or smaller records, or throttle the client.',
      },
    ];
  }
}
