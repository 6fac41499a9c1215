import type { ModuleFault, ModulePhase } from '../ports/module-fault.ts';

/** Converts the rejection of a sandbox. Anything but a fault is a bug of the sandbox, and ends the instance. */
export function toFault(reason: unknown, phase: ModulePhase): ModuleFault {
  if (isFault(reason)) return reason;
  const message = reason instanceof Error ? reason.message : String(reason);
  return { kind: 'crashed', phase, message };
}

/** Whether the instance is gone after it. [PM-53] */
export function isDeadly({ kind }: ModuleFault): boolean {
  return kind === 'timeout' || kind === 'memory' || kind === 'crashed';
}

function isFault(reason: unknown): reason is ModuleFault {
  return (
    typeof reason === 'object' &&
    reason !== null &&
    !(reason instanceof Error) &&
    'kind' in reason &&
    'message' in reason
  );
}
