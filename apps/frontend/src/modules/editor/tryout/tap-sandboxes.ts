import type { SandboxCall, SandboxFactory, SandboxResult } from '@ubii/pm-sandbox';

/** The same sandboxes; what each run gave is seen on its way. */
export function tapSandboxes(
  sandboxes: SandboxFactory,
  onResult: (result: SandboxResult, call: SandboxCall) => void,
  /** A run that failed has no result. */
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
    // Those who opened them close them
    close: () => Promise.resolve(),
  };
}
