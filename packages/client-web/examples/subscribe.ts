// Receives a topic, as callbacks and as a loop. Run: node --import tsx examples/subscribe.ts [url]
import { createClient } from '@ubii/client-web/node';

const client = createClient({ url: process.argv[2] ?? 'http://localhost:8080', name: 'display' });
await client.connect();

// Of any format: look at `format`, and the compiler knows the type of `value`.
const anything = client.subscribe('/garden/wind').onRecord((record) => {
  if (record.format === 'vector2') console.log(`wind from the west: ${record.value.x} m/s`);
});

// Of one format only, five times a second at most, as a loop.
const temperatures = client.subscribe('/garden/temperature', { format: 'double', maxRateHz: 5 });

await Promise.all([anything.ready, temperatures.ready]); // the master has accepted both

client.publish('/garden/wind', 'vector2', { x: 3.2, y: -0.4 });
client.publish('/garden/temperature', 'double', 21.5);

for await (const { value, timestampMs } of temperatures) {
  console.log(`${value} °C, measured ${timestampMs === undefined ? 'some time' : 'just now'}`);
  break; // leaving the loop does not end the subscription
}

await temperatures.close(); // this does; and so does client.close()
await client.close();
