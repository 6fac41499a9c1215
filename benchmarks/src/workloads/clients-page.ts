import { listPageWorkload } from '../topics/list-page-workload.ts';
import { CLIENTS, joinManyClients, UPDATES_HZ } from '../topics/many-clients.ts';
import type { ListPage } from '../topics/topics-page.ts';

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
