import type { EngineHooks, EngineRequest } from '../engine.ts';

/** Libraries whose methods the host runs, as objects a module calls. [PM-4] */
export function createHostModules(
  { hostLibraries }: Pick<EngineRequest, 'hostLibraries'>,
  hooks: EngineHooks,
): Record<string, object> {
  const method =
    (library: string, name: string) =>
    async (...args: unknown[]): Promise<unknown> => {
      try {
        return await hooks.callHost(library, name, args);
      } finally {
        hooks.onResume();
      }
    };
  return Object.fromEntries(
    Object.entries(hostLibraries).map(([library, methods]) => [
      library,
      Object.freeze(Object.fromEntries(methods.map((name) => [name, method(library, name)]))),
    ]),
  );
}
