import { createHttpLibrary, createNodeSandboxes } from '@ubii/pm-sandbox/node';
import type { HostLibrary } from '@ubii/pm-sandbox/node';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import { findBuilt } from '@ubii/program';
import { existsSync } from 'node:fs';

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

function findWorker(): URL {
  const file = findBuilt('module-worker.js', import.meta.url);
  if (existsSync(file)) return file;
  throw new Error('The worker script for modules is missing. Run "npm run build".');
}
