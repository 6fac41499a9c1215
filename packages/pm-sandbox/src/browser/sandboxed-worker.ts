import { createQuickJsEngine } from '../worker/quickjs/quickjs-engine.ts';
import { runWorker } from './run-worker.ts';

/**
 * Stack of QuickJS, bytes. Its frames take up to fifty times as much of the thread's stack, which is
 * about 1 MB in browsers and cannot be made larger.
 */
const STACK_BYTES = 80 * 1024;

runWorker((memory) => {
  const clock = performance;
  return createQuickJsEngine({ stackBytes: STACK_BYTES, nowMs: () => clock.now() }, memory);
});
