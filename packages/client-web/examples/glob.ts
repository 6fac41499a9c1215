// Subscribes to many topics at once. Run: node --import tsx examples/glob.ts [url]
import { createClient } from '@ubii/client-web/node';

const client = createClient({ url: process.argv[2] ?? 'http://localhost:8080', name: 'overview' });
await client.connect();

// "*" is anything within one segment of a topic, "**" anything at all.
const rooms = client.subscribe({ glob: '/house/*/temperature' }, { format: 'double' });
rooms.onRecord(({ topic, value }) => console.log(`glob: ${topic} is ${value}`));

// A regular expression, when a glob does not say enough. It may match anywhere in the topic.
const upstairs = client.subscribe({ regex: /^\/house\/(bed|bath)room\// });
upstairs.onRecord(({ topic, format }) => console.log(`regex: ${topic} holds a ${format}`));

await Promise.all([rooms.ready, upstairs.ready]);

client.publish('/house/kitchen/temperature', 'double', 21);
client.publish('/house/bathroom/temperature', 'double', 24);
client.publish('/house/bathroom/light', 'bool', true);

// Each subscription gets each record once, however many of them match its topic.
for await (const { topic } of upstairs) if (topic.endsWith('/light')) break;

await client.close();
