import { createHttpLibrary, createNodeSandboxes } from '@ubii/pm-sandbox/node';
import type { HostLibrary } from '@ubii/pm-sandbox/node';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** The sandboxes of a node and their libraries. */
export interface OpenSandboxes {
  readonly sandboxes: SandboxFactory;
  /** Names of the libraries modules get in `state.modules`. */
  readonly libraries: readonly string[];
}

/**
 * Opens the sandboxes.
 *
 * @param allowedOrigins origins that modules may read from; without any, modules have no library `http`
 * @param memoryBytes memory of all sandboxed modules; undefined: a share of the machine's memory
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

/** Finds the worker script beside the built program. A program that runs from its sources uses the last build. */
function findWorker(): URL {
  const places = ['./module-worker.js', '../dist/module-worker.js'].map(
    (path) => new URL(path, import.meta.url),
  );
  const found = places.find((place) => existsSync(fileURLToPath(place)));
  if (found === undefined)
    throw new Error('The worker script for modules is missing. Run "npm run build".');
  return found;
}
