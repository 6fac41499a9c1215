import { listPageWorkload } from '../topics/list-page-workload.ts';
import { publishManyTopics, TOPICS, UPDATES_HZ } from '../topics/many-topics.ts';
import type { ListPage } from '../topics/topics-page.ts';

const OPEN_TIMEOUT_MS = 60_000;

/** The topics page with very many topics, seen and scrolled, beside a plain list of numbers. */
export const topicsPage = listPageWorkload({
  name: 'topics-page',
  title: `Topics page: ${TOPICS} topics, ${UPDATES_HZ} updates/s`,
  opened: 'opened, all topics there',
  updatesHz: UPDATES_HZ,
  fill: publishManyTopics,
  whenThere: allTopicsThere,
});

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
