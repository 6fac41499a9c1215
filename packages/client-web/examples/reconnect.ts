// Says what happens to the connection. Run: node --import tsx examples/reconnect.ts [url]
// Then stop the master and start it again.
import { createClient } from '@ubii/client-web/node';

const client = createClient({
  url: process.argv[2] ?? 'http://localhost:8080',
  name: 'stayer',
  reconnect: { initialDelayMs: 100, maxDelayMs: 1_000 },
});

client.onState((state) => {
  if (state.status === 'connected') {
    console.log(state.resumed ? 'back as the same client' : 'connected as a new client');
  } else if (state.status === 'reconnecting' && state.attempt === 1) {
    console.log('lost the master, trying again');
  } else if (state.status === 'closed') {
    // With an error it is final: another client uses this identity, or the client gave up.
    console.log(state.error === undefined ? 'closed' : `closed: ${state.error.reason}`);
  }
});
client.onError((problem) => console.log(problem.message));

await client.connect();

// Subscriptions, devices and the identity stand through it all. Of what is published meanwhile the
// newest value of each topic is sent after the reconnect.
for await (const { value } of client.subscribe('/stayer/stop', { format: 'bool' })) {
  if (value) break;
}
await client.close();
