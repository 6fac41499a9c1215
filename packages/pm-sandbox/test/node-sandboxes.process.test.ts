import { createNodeSandboxes } from '../src/node/index.ts';
import { describeSandboxes } from '../src/testing/sandbox-suite.ts';
import { WORKER_FILE } from './build-worker.ts';

const createSandboxes = () => createNodeSandboxes({ workerFile: WORKER_FILE, maxWorkers: 2 });

describeSandboxes('Node, sandboxed', { createSandboxes, isTrusted: false, hasLimits: true });
describeSandboxes('Node, trusted', { createSandboxes, isTrusted: true, hasLimits: true });
