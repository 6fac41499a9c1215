import { startMasterProcess } from '../brokers/master-process.ts';
import { findChromium } from '../browser/chromium.ts';
import { publishManyTopics, TOPICS, UPDATES_HZ } from '../topics/many-topics.ts';
import { listFigures, listSubject, measureList } from '../topics/measure-list.ts';
import { serveBareList, startListBrowser, type ListPage } from '../topics/topics-page.ts';
import type { Workload } from './workload.ts';

const REFERENCE = 'bare list';
const SUBJECT = 'topics page';
const OPEN_TIMEOUT_MS = 60_000;

/** The topics page with very many topics, seen and scrolled, beside a plain list of numbers. */
export const topicsPage: Workload = {
  name: 'topics-page',
  group: 'topics-page',
  title: `Topics page: ${TOPICS} topics, ${UPDATES_HZ} updates/s`,
  figures: listFigures(SUBJECT, 'opened, all topics there'),
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
    const topics = await parts.get('topics', () => publishManyTopics(master.url));
    const browser = await parts.get('browser', startListBrowser);
    const bare = await parts.get('bare list', serveBareList);
    const url = `${master.url.replace(/\/$/, '')}/topics`;
    const load = {
      get published() {
        return topics.published;
      },
      updatesHz: UPDATES_HZ,
      whenThere: allTopicsThere,
    };
    return [
      listSubject(REFERENCE, (options) =>
        measureList(browser, bare.url, undefined, master.pid, options),
      ),
      listSubject(SUBJECT, (options) => measureList(browser, url, load, master.pid, options)),
    ];
  },
};

/** Everything unfolded: as many rows as there can be. */
async function allTopicsThere({ page }: ListPage): Promise<void> {
  // The master has some of its own, too
  const count = page.getByText(new RegExp(`^${TOPICS / 1000}\\s?0\\d\\d$`)).first();
  await count.waitFor({ timeout: OPEN_TIMEOUT_MS });
  await page.getByRole('button', { name: 'Order and folding' }).click();
  await page.getByRole('menuitem', { name: 'Expand all' }).click();
  await page
    .getByRole('row', { name: /value-0/ })
    .first()
    .waitFor();
}
