/** Builds the worker of `createNodeSandboxes` into one file, an ES module. */
export function buildNodeWorker(outfile: string): Promise<void>;
