import { Script } from 'node:vm';
import { getHeapStatistics } from 'node:v8';
import { parentPort, workerData } from 'node:worker_threads';
import { type SourcePosition, createV8Engine } from '../worker/v8/v8-engine.ts';
import type { HostBatch, WorkerStart } from '../worker/protocol.ts';
import { MemoryAccount } from '../worker/memory-account.ts';
import { createQuickJsEngine } from '../worker/quickjs/quickjs-engine.ts';
import { evaluateLibrary } from '../worker/v8/evaluate-callback.ts';
import { WorkerLoop } from '../worker/worker-loop.ts';
import { processCpuMs } from './process-cpu.ts';
import { createProgressWriter } from './shared-progress.ts';

const FILE_NAME = 'ubii-module.js';

/**
 * Returns the position of a syntax error. V8 reports it only when a script with a filename is compiled: first line
 * `file:line`, then the line itself, then a mark under the position.
 *
 * @param text starts with one character that is not the author's
 */
function locateSyntaxError(text: string): SourcePosition | undefined {
  try {
    new Script(text, { filename: FILE_NAME });
    return undefined;
  } catch (thrown) {
    const lines = String((thrown as Error).stack).split('\n');
    // eslint-disable-next-line ubii/no-native-patterns -- of a constant
    const line = Number(new RegExp(`^${FILE_NAME}:(\\d+)$`).exec(lines[0] ?? '')?.[1]);
    if (!(line > 0)) return undefined;
    const column = (lines[2] ?? '').indexOf('^') + 1;
    return { line, column: Math.max(1, column - (line === 1 ? 1 : 0)) };
  }
}

/** Data from `createNodeSandboxes`. */
export interface NodeWorkerData {
  readonly start: WorkerStart;
  readonly progress: SharedArrayBuffer;
}

/**
 * Stack of QuickJS, bytes. Its frames take up to fifty times as much of the thread's stack, which is
 * made 16 MB: deep recursion ends as an exception of the module, never as one of the thread.
 */
const STACK_BYTES = 256 * 1024;

const port = parentPort;
if (port === null) throw new Error('this file is a worker');
const { start, progress } = workerData as NodeWorkerData;
const nowMs = (): number => performance.now();

// Loaded before the first call, whose time it must not take. What is sent meanwhile waits in the port.
const engine =
  start.kind === 'trusted'
    ? createV8Engine({ locateSyntaxError })
    : await createQuickJsEngine(
        { stackBytes: STACK_BYTES, nowMs, cpuMs: processCpuMs },
        new MemoryAccount(start.memory),
      );
const loop = new WorkerLoop({
  engine,
  hostLibraries: start.hostLibraries,
  post(batch, transfer) {
    if (batch.messages.length > 0) port.postMessage(batch, transfer);
  },
  async importLibrary(name) {
    if (!Object.hasOwn(start.libraries, name)) return undefined;
    const library = (await import(start.libraries[name]!)) as { default?: unknown };
    return library.default ?? library;
  },
  ...createProgressWriter(progress),
  later: (fn) => void setImmediate(fn),
  nowMs,
  ...(start.kind === 'trusted' && { sharedBytes: heapBytes, evaluateLibrary }),
});

// A timer of one trusted module that throws is no reason to end the others.
process.on('uncaughtException', (thrown) => loop.handleStray(thrown));
process.on('unhandledRejection', (thrown) => loop.handleStray(thrown));
port.on('message', (batch: HostBatch) => loop.handleBatch(batch));

/** Memory that trusted instances share: the heap of this thread, and external buffers. */
function heapBytes(): number {
  const { used_heap_size, external_memory } = getHeapStatistics();
  return used_heap_size + external_memory;
}
