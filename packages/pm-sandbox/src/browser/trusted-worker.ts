import { evaluateLibrary } from '../worker/v8/evaluate-callback.ts';
import { createV8Engine } from '../worker/v8/v8-engine.ts';
import { keepGraphics } from './graphics.ts';
import { runWorker } from './run-worker.ts';

runWorker(() => createV8Engine(), { evaluateLibrary }, keepGraphics());
