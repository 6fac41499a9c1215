import type { ModuleFault, ModuleFaultKind, ModulePhase } from '../ports/module-fault.ts';
import { MAX_TEXT_LENGTH } from '../sandbox-limits.ts';

/** Carries a fault through code that throws; the port's promises reject with the fault itself. */
export class ModuleError extends Error {
  readonly fault: ModuleFault;

  constructor(fault: ModuleFault, options?: ErrorOptions) {
    super(fault.message, options);
    this.name = 'ModuleError';
    this.fault = fault;
  }
}

/** Whether an instance with such a fault is gone. [PM-53] */
export function isFatal({ kind }: ModuleFault): boolean {
  return kind === 'timeout' || kind === 'memory' || kind === 'crashed';
}

/** A fault with its message cut to what is sent. */
export function moduleFault(
  kind: ModuleFaultKind,
  phase: ModulePhase,
  message: string,
  position?: { readonly line: number; readonly column: number } | undefined,
): ModuleFault {
  const { line, column } = position ?? {};
  return { kind, phase, message: cutText(message), line, column };
}

/** The fault in something that was caught. */
export function faultOf(thrown: unknown, phase: ModulePhase): ModuleFault {
  if (thrown instanceof ModuleError || thrown instanceof EngineBrokenError) return thrown.fault;
  return moduleFault('crashed', phase, `The sandbox failed: ${describeThrown(thrown)}`);
}

/** Describes a thrown value in one sentence; it may be anything, even an object that throws when read. */
export function describeThrown(thrown: unknown): string {
  try {
    if (typeof thrown === 'object' && thrown !== null && 'message' in thrown) {
      const { name, message } = thrown as { name?: unknown; message: unknown };
      return typeof name === 'string' && name !== '' && name !== 'Error'
        ? `${name}: ${String(message)}`
        : String(message);
    }
    return String(thrown);
  } catch {
    return 'a value that cannot be shown';
  }
}

/** Text as long as it may be. */
export function cutText(text: string): string {
  return text.length <= MAX_TEXT_LENGTH ? text : `${text.slice(0, MAX_TEXT_LENGTH - 1)}…`;
}

/**
 * The engine itself failed, as when the stack of its thread overflows: what is in it cannot go on. An
 * engine belongs to one instance.
 */
export class EngineBrokenError extends Error {
  readonly fault: ModuleFault;

  constructor(phase: ModulePhase, cause: unknown) {
    super('the engine failed', { cause });
    this.name = 'EngineBrokenError';
    const message = `The engine failed in ${phase}: ${describeThrown(cause)}`;
    this.fault = moduleFault('crashed', phase, message);
  }
}
