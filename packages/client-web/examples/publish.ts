// Publishes values of different data formats. Run: node --import tsx examples/publish.ts [url]
import { createClient } from '@ubii/client-web/node';

const client = createClient({
  url: process.argv[2] ?? 'http://localhost:8080',
  name: 'weather station',
  publishIntervalMs: 50, // what is published within 50 ms travels as one frame
});
await client.connect();

// The format decides what the value has to be: the compiler refuses { x: 1 } or '21.5' here.
client.publish('/garden/temperature', 'double', 21.5);
client.publish('/garden/wind', 'vector2', { x: 3.2, y: -0.4 });
client.publish('/garden/raining', 'bool', false);

// The master keeps this value for 10 minutes after the client left: a later start finds it. An hour at most.
client.publish('/garden/target', 'double', 22, { keepSeconds: 600 });

// Sent at once, with what waits before it.
client.publish('/garden/door', 'string', 'open', { immediate: true });

const { recordsOut } = client.counters;
console.log(`${recordsOut} records sent as ${client.name}`);

await client.close(); // sends what is left, then deregisters
