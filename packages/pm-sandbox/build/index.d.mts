/** Paths of the workers for browsers, and the policies to serve them with. */
export const SANDBOX_WORKER_FILES: {
  readonly [kind in 'trusted' | 'sandboxed']: { readonly path: string; readonly csp: string };
};

/** Builds the worker of `createNodeSandboxes` into one file, an ES module. */
export function buildNodeWorker(outfile: string): Promise<void>;

/** Builds the workers of `createBrowserSandboxes` under their paths in a folder. */
export function buildBrowserWorkers(outdir: string): Promise<void>;

/** Vite plugin: serves the browser workers with their policies, adds them to the build. */
export function sandboxWorkersPlugin(): { name: string };

/**
 * Writes an asset set: a folder of its name with its files and `manifest.json`. [PM-92]
 *
 * @param outdir where the folders of all sets are
 * @param about members of the manifest: name, version, licence, source and, for a script, `library`
 * @param contents bytes by path
 */
export function writeAssetSet(
  outdir: string,
  about: {
    readonly name: string;
    readonly version: string;
    readonly licence: string;
    readonly source: string;
    readonly library?: string;
  },
  contents: Readonly<Record<string, Uint8Array>>,
): void;
