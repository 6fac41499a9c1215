import type { SandboxFactory } from '@ubii/pm-sandbox';
import {
  createHttpLibrary,
  createNodeSandboxes,
  defaultModuleMemory,
  defaultSessionMemory,
  type HostLibrary,
} from '@ubii/pm-sandbox/node';
import { DEFAULT_LIMITS, type Limits } from '../../index.ts';

/** Sandboxes of this master, and the libraries and assets available in them. */
export interface OpenSandboxes {
  readonly sandboxes: SandboxFactory;
  /** Names of the libraries that modules get in `state.modules`. */
  readonly libraries: readonly string[];
}

/**
 * Sandboxes on threads of this process. The first of them starts with the first module.
 *
 * @param workerFile the worker, as the build makes it
 * @param limits of the memory of sandboxed modules, bytes
 * @param allowedOrigins what modules may read from over HTTP; none: there is no library for it
 */
export function openSandboxes(
  workerFile: URL,
  allowedOrigins: readonly string[],
  { moduleBytes, moduleBytesPerSession }: Pick<Limits, 'moduleBytes' | 'moduleBytesPerSession'>,
): OpenSandboxes {
  const hostLibraries: Readonly<Record<string, HostLibrary>> =
    allowedOrigins.length === 0 ? {} : { http: createHttpLibrary(allowedOrigins) };
  return {
    sandboxes: createNodeSandboxes({
      workerFile,
      hostLibraries,
      memoryBytes: moduleBytes,
      ownerMemoryBytes: moduleBytesPerSession,
    }),
    libraries: Object.keys(hostLibraries),
  };
}

/** All limits: those that were set, those that depend on the machine, and those that are built in. */
export function limitsOfMachine(set: Partial<Limits>): Limits {
  const moduleBytes = set.moduleBytes ?? defaultModuleMemory();
  return {
    ...DEFAULT_LIMITS,
    moduleBytes,
    moduleBytesPerSession: defaultSessionMemory(moduleBytes),
    ...set,
  };
}
