import type { Findings } from '../measure/findings.ts';
import type { Progress } from '../measure/test-run.ts';
import type { LoadParameters } from './load-parameters.ts';

/** What the page calls of the worker that runs the load test. */
export interface LoadWorker {
  run(url: string, parameters: LoadParameters): Promise<Findings>;
  stop(): Promise<void>;
}

/** What the worker calls of the page. */
export interface LoadPage {
  /** A client was registered. */
  addClient(id: string): void;
  /** A client was removed. */
  removeClient(id: string): void;
  showProgress(progress: Progress): void;
}
