// Runs a processing module of a session. Run: node --import tsx examples/processing.ts [url] [worker]
import { createClient } from '@ubii/client-web/node';
import { createProcessingNode } from '@ubii/client-web/processing';
import { defineProcessingModule, moduleToWire } from '@ubii/pm-sandbox';
import { buildNodeWorker } from '@ubii/pm-sandbox/build';
import { createNodeSandboxes } from '@ubii/pm-sandbox/node';

const workerFile = process.argv[3] ?? 'module-worker.js';
await buildNodeWorker(workerFile); // programs do this once, when they are built

const client = createClient({ url: process.argv[2] ?? 'http://localhost:8080', name: 'helper' });
const sandboxes = createNodeSandboxes({ workerFile });
const node = createProcessingNode(client, { kind: 'node', sandboxes });

const loudness = defineProcessingModule({
  name: 'loudness',
  inputs: { level: 'double' },
  outputs: { text: 'string' },
  mode: { triggerOnInput: {} },
  // Sent as text: it sees nothing of this file.
  onProcessing(_deltaTimeMs, { level }) {
    if (level?.double === undefined) return undefined;
    return { outputs: { text: { string: level.double > 0.5 ? 'loud' : 'quiet' } } };
  },
});

await client.connect();
await node.start();

const texts = client.subscribe('/room/text', { format: 'string' });
await texts.ready;
client.publish('/room/level', 'double', 0.75);

// Any client may start a session that names this node; here it is the same program.
const session = await client.call('sessionRuntimeStart', {
  name: 'listening',
  processingModules: [{ ...moduleToWire(loudness), nodeId: client.id }],
  ioMappings: [
    {
      processingModuleName: 'loudness',
      inputMappings: [{ inputName: 'level', topic: '/room/level' }],
      outputMappings: [{ outputName: 'text', topic: '/room/text' }],
    },
  ],
});

for await (const { value } of texts) {
  console.log(`the room is ${value}`);
  break;
}

await client.call('sessionRuntimeStop', { id: session.id });
await node.stop(); // ends what runs, and tells the master
await client.close();
await sandboxes.close();
