/**
 * The limit of the binding of libzmq that is usual on Node.js: a ROUTER that sends every message back to its DEALER. Not a
 * product: no clients, no topics, no checks, no slow consumers.
 *
 * Plain JavaScript, so that it runs in the same plain Node as the built master.
 */
import { Router } from 'zeromq';

const router = new Router();
await router.bind('tcp://127.0.0.1:*');
process.stdout.write(`${JSON.stringify({ topicData: router.lastEndpoint })}\n`);
process.on('SIGTERM', () => process.exit(0));
for await (const [identity, content] of router) await router.send([identity, '', content]);
