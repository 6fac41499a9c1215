import { createClient } from '@ubii/client-web/node';

import type { Part } from '../parts/shared-parts.ts';
import { listPageWorkload } from '../topics/list-page-workload.ts';
import type { ListPage } from '../topics/topics-page.ts';

const CLIENTS = 500;
const UPDATES_HZ = 1_000;
/** Connected together: each has a connection of its own. */
const AT_ONCE = 25;
/** Published together: as often as a pointer moves. */
const TICK_MS = 16;

/** Clients that all publish. */
interface ManyClients extends Part {
  /** Records published so far. */
  readonly published: number;
}

/** Many clients, each with a topic it publishes a number on in turn, at a steady rate, until stopped. */
async function joinManyClients(url: string): Promise<ManyClients> {
  const clients = Array.from({ length: CLIENTS }, (_, index) =>
    createClient({ url, name: `benchmark client ${index + 1}` }),
  );
  for (let i = 0; i < CLIENTS; i += AT_ONCE) {
    await Promise.all(clients.slice(i, i + AT_ONCE).map((client) => client.connect()));
  }
  let published = 0;
  const startedMs = performance.now();
  const timer = setInterval(() => {
    const due = ((performance.now() - startedMs) / 1000) * UPDATES_HZ;
    for (; published < due; published++) {
      const client = clients[published % CLIENTS]!;
      client.publish(`/${client.id}/value`, 'double', Math.sin(published / 1000) * 100);
    }
  }, TICK_MS);
  return {
    get published() {
      return published;
    },
    stop: async () => {
      clearInterval(timer);
      await Promise.all(clients.map((client) => client.close()));
    },
  };
}

const OPEN_TIMEOUT_MS = 60_000;

/** The clients page with many clients that all publish, seen and scrolled, beside a plain list of numbers. */
export const clientsPage = listPageWorkload({
  name: 'clients-page',
  title: `Clients page: ${CLIENTS} clients, ${UPDATES_HZ} updates/s`,
  opened: 'opened, all clients there',
  updatesHz: UPDATES_HZ,
  fill: joinManyClients,
  whenThere: allClientsThere,
});

/** Pages of earlier rounds may stay for a while as clients that are away. */
async function allClientsThere({ page }: ListPage): Promise<void> {
  const head = page.getByRole('treegrid', { name: 'Clients' });
  await head.waitFor({ timeout: OPEN_TIMEOUT_MS });
  await page.waitForFunction(
    (count) =>
      Number(document.querySelector('[aria-rowcount]')?.getAttribute('aria-rowcount')) > count,
    CLIENTS,
    { timeout: OPEN_TIMEOUT_MS },
  );
}
