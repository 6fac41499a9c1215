import { createClient } from '@ubii/client-web/node';
import { SOURCE_HERTZ } from './large-session.ts';

/** Publishes a number to each topic, many times a second, until it is stopped. */
export async function publishSources(
  url: string,
  topics: readonly string[],
): Promise<{ stop(): Promise<void> }> {
  const client = createClient({ url, name: 'benchmark sources' });
  await client.connect();
  let count = 0;
  const timer = setInterval(() => {
    count += 1;
    topics.forEach((topic, index) =>
      client.publish(topic, 'double', 100 * index + Math.sin(count / 10)),
    );
  }, 1000 / SOURCE_HERTZ);
  return {
    stop: async () => {
      clearInterval(timer);
      await client.close();
    },
  };
}
