/** Where browsers find the workers, and with which policies they are to be served. */
export const SANDBOX_WORKER_FILES: {
  readonly [kind in 'trusted' | 'sandboxed']: { readonly path: string; readonly csp: string };
};

/** Builds the worker of `createNodeSandboxes` into one file, an ES module. */
export function buildNodeWorker(outfile: string): Promise<void>;

/** Builds the workers of `createBrowserSandboxes` under their paths in a folder. */
export function buildBrowserWorkers(outdir: string): Promise<void>;

/** Vite plugin: serves the browser workers with their policies, adds them to the build. */
export function sandboxWorkersPlugin(): { name: string };
