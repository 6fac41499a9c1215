import type { UbiiClient } from '@ubii/client-web/node';
import type { Clock } from '@ubii/timing';

const INTERVAL_MS = 1_000;

/** Topic on which a bridge says how it does, as JSON. [BR-33] */
export function bridgeTopic(clientId: string): string {
  return `/${clientId}/bridge`;
}

/** Publishes the report each second, when it has changed. @returns ends it */
export function startReports(client: UbiiClient, clock: Clock, report: () => object): () => void {
  let published = '';
  const publish = (): void => {
    const text = JSON.stringify({ version: 1, ...report() });
    const key = `${client.id} ${text}`;
    if (client.state.status !== 'connected' || key === published) return;
    published = key;
    client.publish(bridgeTopic(client.id), 'string', text);
  };
  publish();
  return clock.every(INTERVAL_MS, publish);
}
