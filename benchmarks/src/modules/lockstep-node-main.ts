/**
 * A processing node as a program would make it, which also says how long its shares of passes took.
 *
 * argv: url of the master, name, worker file.
 */
import { createClient } from '@ubii/client-web/node';
import { createProcessingNode } from '@ubii/client-web/processing';
import { createModuleRuntime, type ModuleRuntimeOptions } from '@ubii/pm-sandbox';
import { createNodeSandboxes } from '@ubii/pm-sandbox/node';
import { percentile } from '../statistics.ts';
import { echoTopics, LOCKSTEP_MODULE, passTopics } from './lockstep-module.ts';

const [url, name, workerFile] = process.argv.slice(2) as [string, string, string];

let tookMs: number[] = [];

function createTimedRuntime(options: ModuleRuntimeOptions) {
  const runtime = createModuleRuntime(options);
  const runPass = runtime.runPass.bind(runtime);
  runtime.runPass = async (pass) => {
    const startMs = performance.now();
    const reply = await runPass(pass);
    tookMs.push(performance.now() - startMs);
    return reply;
  };
  return runtime;
}

const client = createClient({ url, name, publishIntervalMs: 1 });
await client.connect();
const node = createProcessingNode(client, {
  sandboxes: createNodeSandboxes({ workerFile }),
  kind: 'node',
  acceptsWork: false,
  modules: [LOCKSTEP_MODULE],
  createRuntime: createTimedRuntime,
});
await node.start();

const { ping, pong } = echoTopics(name);
const { ask, passes } = passTopics(name);
const pings = client.subscribe(ping, { format: 'vector3' }).onRecord(({ value }) => {
  client.publish(pong, 'vector3', value, { immediate: true });
});
const questions = client.subscribe(ask, { format: 'vector3' }).onRecord(() => {
  const sorted = tookMs.sort((a, b) => a - b);
  const value = {
    x: percentile(sorted, 0.5) || 0,
    y: percentile(sorted, 0.95) || 0,
    z: sorted.length,
  };
  tookMs = [];
  client.publish(passes, 'vector3', value, { immediate: true });
});
await Promise.all([pings.ready, questions.ready]);
process.stdout.write(`${JSON.stringify({ id: client.id })}\n`);
process.on('SIGTERM', () => process.exit(0));
