import { startMasterProcess } from '../brokers/master-process.ts';
import { findChromium } from '../browser/chromium.ts';
import { CLIENTS, joinManyClients, UPDATES_HZ } from '../topics/many-clients.ts';
import { listFigures, listSubject, measureList } from '../topics/measure-list.ts';
import { serveBareList, startListBrowser, type ListPage } from '../topics/topics-page.ts';
import type { Workload } from './workload.ts';

const REFERENCE = 'bare list';
const SUBJECT = 'clients page';
const OPEN_TIMEOUT_MS = 60_000;

/** The clients page with many clients that all publish, seen and scrolled, beside a plain list of numbers. */
export const clientsPage: Workload = {
  name: 'clients-page',
  group: 'clients-page',
  title: `Clients page: ${CLIENTS} clients, ${UPDATES_HZ} updates/s`,
  figures: listFigures(SUBJECT, 'opened, all clients there'),
  reference: REFERENCE,
  // The browser has many threads of its own.
  placement: 'anywhere',
  roundShare: 1 / 5,
  whyNot: () =>
    findChromium() === undefined
      ? 'there is no Chromium; install one, or name it in UBII_CHROMIUM'
      : undefined,
  open: async ({ parts, master: file, profileDir }) => {
    const master = await parts.get('master', () =>
      startMasterProcess({ master: file, profileDir }),
    );
    const clients = await parts.get('clients', () => joinManyClients(master.url));
    const browser = await parts.get('browser', startListBrowser);
    const bare = await parts.get('bare list', serveBareList);
    const url = `${master.url.replace(/\/$/, '')}/clients`;
    const load = {
      get published() {
        return clients.published;
      },
      updatesHz: UPDATES_HZ,
      whenThere: allClientsThere,
    };
    return [
      listSubject(REFERENCE, (options) =>
        measureList(browser, bare.url, undefined, master.pid, options),
      ),
      listSubject(SUBJECT, (options) => measureList(browser, url, load, master.pid, options)),
    ];
  },
};

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
