// Calls services of the master. Run: node --import tsx examples/services.ts [url]
import { ConnectionError, ServiceError, createClient } from '@ubii/client-web/node';

const client = createClient({
  url: process.argv[2] ?? 'http://localhost:8080',
  name: 'inspector',
  serviceTimeoutMs: 5_000,
});
await client.connect();

// The name of the service decides on request and reply, for the compiler as well.
const { name } = await client.call('serverConfiguration');
console.log(`the master calls itself "${name}"`);

const { elements: clients } = await client.call('clientGetList', {
  elements: [{ name: 'inspector' }], // a profile: what the clients have in common
});
console.log(`${clients.length} client is called "inspector"`);

try {
  await client.call('clientDeregistration', { id: 'unknown' });
} catch (error) {
  // The master said no, or could not be asked.
  if (error instanceof ServiceError) console.log(`refused: ${error.code}`);
  else if (error instanceof ConnectionError) console.log(`no answer: ${error.reason}`);
  else throw error;
}

await client.close();
