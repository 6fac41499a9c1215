// Stamps records in the master's time. Run: node --import tsx examples/master-time.ts [url]
import { createClient } from '@ubii/client-web/node';

const client = createClient({
  url: process.argv[2] ?? 'http://localhost:8080',
  name: 'glove',
  stampInMasterTime: true, // else records have the time of this machine
});
await client.connect(); // with the connection comes the first measurement

const { estimate } = client.masterTime; // undefined with masters that do not tell their time
if (estimate !== undefined) {
  const side = estimate.offsetMs > 0 ? 'ahead' : 'behind';
  console.log(`the clock of the master is ${side}, within ${Math.ceil(estimate.errorMs)} ms`);
}

const bends = client.subscribe('/glove/bend', { format: 'double' });
await bends.ready;
client.publish('/glove/bend', 'double', 0.5);
for await (const { timestampMs } of bends) {
  const ageMs = client.masterTime.nowMs() - (timestampMs ?? 0);
  console.log(ageMs < 5_000 ? 'the record came soon' : 'the record came late');
  break;
}

await client.close();
