import { createHttpLibrary, createNodeSandboxes } from '@ubii/pm-sandbox/node';
import type { HostLibrary } from '@ubii/pm-sandbox/node';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** Where code runs, and what it finds there. */
export interface OpenSandboxes {
  readonly sandboxes: SandboxFactory;
  /** Names of the libraries modules get in `state.modules`. */
  readonly libraries: readonly string[];
}

/**
 * @param allowedOrigins what modules may read from; none: there is no library for it
 * @param memoryBytes of all sandboxed modules; undefined: by the machine
 */
export function openSandboxes(
  allowedOrigins: readonly string[],
  memoryBytes: number | undefined,
): OpenSandboxes {
  const hostLibraries: Readonly<Record<string, HostLibrary>> =
    allowedOrigins.length === 0 ? {} : { http: createHttpLibrary(allowedOrigins) };
  return {
    sandboxes: createNodeSandboxes({
      workerFile: findWorker(),
      hostLibraries,
      ...(memoryBytes !== undefined && { memoryBytes }),
    }),
    libraries: Object.keys(hostLibraries),
  };
}

/** Beside the program when it is built; from the sources the build of before is taken. */
function findWorker(): URL {
  const places = ['./module-worker.js', '../dist/module-worker.js'].map(
    (path) => new URL(path, import.meta.url),
  );
  const found = places.find((place) => existsSync(fileURLToPath(place)));
  if (found === undefined)
    throw new Error('The worker for modules is not built. Run npm run build');
  return found;
}
