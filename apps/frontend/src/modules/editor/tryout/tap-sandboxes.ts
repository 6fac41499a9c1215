import type { SandboxCall, SandboxFactory, SandboxResult } from '@ubii/pm-sandbox';

/** Wraps sandboxes to observe the result of each run. */
export function tapSandboxes(
  sandboxes: SandboxFactory,
  onResult: (result: SandboxResult, call: SandboxCall) => void,
  /** Called for failed runs, which have no result. */
  onFailure: () => void = () => undefined,
): SandboxFactory {
  return {
    open(request, events) {
      const sandbox = sandboxes.open(request, events);
      return {
        create: () => sandbox.create(),
        halt: () => sandbox.halt(),
        destroy: () => sandbox.destroy(),
        terminate: () => sandbox.terminate(),
        async run(call) {
          const result = await sandbox.run(call).catch((fault: unknown) => {
            onFailure();
            throw fault;
          });
          onResult(result, call);
          return result;
        },
      };
    },
    check: (source) => sandboxes.check(source),
    // The owner of the wrapped sandboxes closes them.
    close: () => Promise.resolve(),
  };
}
