import type { WorkerKind } from './worker/protocol.ts';
import files from './sandbox-worker-files.json' with { type: 'json' };

/** A worker script as browsers load it. */
export interface SandboxWorkerFile {
  /** On the origin of the page. */
  readonly path: string;
  /**
   * `Content-Security-Policy` of its response. A worker obeys the policy of its own script, not that
   * of the page: this one leaves it no network, also when code in it is made from text.
   */
  readonly csp: string;
}

/** The scripts of `createBrowserSandboxes`, each to be served with its policy. */
export const SANDBOX_WORKER_FILES: Readonly<Record<WorkerKind, SandboxWorkerFile>> = files;
