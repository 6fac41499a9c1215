// Two clients of this machine: one publishes 100 times a second, the other measures the longest time without a record.
import { createClient } from '@ubii/client-web/node';

const PERIOD_MS = 10;
const url = process.argv[2]!;

const publisher = createClient({ url, name: 'gap, publisher', publishIntervalMs: 0 });
const subscriber = createClient({ url, name: 'gap, subscriber' });
await Promise.all([publisher.connect(), subscriber.connect()]);
const topic = `/${publisher.id}/gap`;
let published = 0;
let longestMs = 0;
let lastMs = performance.now();
// Without a connection only the newest record is kept: times between arrivals tell more than those of records.
const look = (): void => {
  const nowMs = performance.now();
  longestMs = Math.max(longestMs, nowMs - lastMs - PERIOD_MS);
};
const subscription = subscriber.subscribe(topic, { format: 'double' });
subscription.onRecord(() => {
  look();
  lastMs = performance.now();
});
await subscription.ready;
setInterval(() => publisher.publish(topic, 'double', ++published), PERIOD_MS);

process.on('message', (message) => {
  if (message === 'begin') longestMs = 0;
  else look();
  process.send?.(longestMs);
});
process.on('disconnect', () => process.exit(0));
process.send?.('ready');
