import { createClient } from '@ubii/client-web/node';
import type { UbiiClient } from '@ubii/client-web';

import type { Part } from '../parts/shared-parts.ts';
import { listPageWorkload } from '../topics/list-page-workload.ts';
import type { ListPage } from '../topics/topics-page.ts';

const TOPICS = 10_000;
const UPDATES_HZ = 5_000;
const CLIENTS = 20;
/** Published together: as often as a pointer moves. */
const TICK_MS = 16;

/** Publishers of many topics. */
interface ManyTopics extends Part {
  /** Records published so far. */
  readonly published: number;
}

/** Ten levels of names do not matter, many names do: `/<client>/sensor-7/value-3`. */
function topicsOf(client: UbiiClient): string[] {
  const count = TOPICS / CLIENTS;
  return Array.from(
    { length: count },
    (_, index) => `/${client.id}/sensor-${Math.floor(index / 10)}/value-${index % 10}`,
  );
}

/** Publishes a number on each topic once, and from then on in turn, at a steady rate, until stopped. */
async function publishManyTopics(url: string): Promise<ManyTopics> {
  const publishers = await Promise.all(
    Array.from({ length: CLIENTS }, async (_, index) => {
      const client = createClient({ url, name: `benchmark sensors ${index + 1}` });
      await client.connect();
      return { client, topics: topicsOf(client) };
    }),
  );
  let published = 0;
  const publish = (): void => {
    const { client, topics } = publishers[published % CLIENTS]!;
    const topic = topics[Math.floor(published / CLIENTS) % topics.length]!;
    client.publish(topic, 'double', Math.sin(published / 1000) * 100);
    published += 1;
  };
  while (published < TOPICS) publish();
  const startedMs = performance.now();
  const timer = setInterval(() => {
    const due = ((performance.now() - startedMs) / 1000) * UPDATES_HZ;
    while (published - TOPICS < due) publish();
  }, TICK_MS);
  return {
    get published() {
      return published;
    },
    stop: async () => {
      clearInterval(timer);
      await Promise.all(publishers.map(({ client }) => client.close()));
    },
  };
}

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
