import type { SandboxFactory } from '@ubii/pm-sandbox';
import { createHttpLibrary, createNodeSandboxes, type HostLibrary } from '@ubii/pm-sandbox/node';

/** Where code runs on this master, and what it finds there. */
export interface OpenSandboxes {
  readonly sandboxes: SandboxFactory;
  /** Names of the libraries that modules get in `state.modules`. */
  readonly libraries: readonly string[];
}

/**
 * Sandboxes on threads of this process. The first of them starts with the first module.
 *
 * @param workerFile the worker, as the build makes it
 * @param allowedOrigins what modules may read from over HTTP; none: there is no library for it
 */
export function openSandboxes(workerFile: URL, allowedOrigins: readonly string[]): OpenSandboxes {
  const hostLibraries: Readonly<Record<string, HostLibrary>> =
    allowedOrigins.length === 0 ? {} : { http: createHttpLibrary(allowedOrigins) };
  return {
    sandboxes: createNodeSandboxes({ workerFile, hostLibraries }),
    libraries: Object.keys(hostLibraries),
  };
}
