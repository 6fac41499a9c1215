import type { BackendName } from './tensorflow/backend-names.ts';

/** Replacements of a backend that fails while it computes. */
export const NEXT_BACKEND: Readonly<Record<BackendName, BackendName | undefined>> = {
  webgpu: 'wasm',
  webgl: 'wasm',
  wasm: 'cpu',
  cpu: undefined,
};

/** A `ModuleFault`, as far as it matters here. */
export interface PreviousFault {
  readonly kind: string;
  readonly message: string;
  readonly isOfOther?: boolean | undefined;
}

/** A backend instead of the chosen one, and why. */
export interface Replacement {
  readonly backend: BackendName;
  /** One sentence for each: for `backendFault`, and for `problem`. */
  readonly fault: string;
  readonly problem: string;
}

/**
 * Returns why the graphics card is not to be used by an instance that was restarted; undefined when it may be. Whatever
 * held the worker up for so long would hold it up again.
 */
export function suspicionOf(fault: PreviousFault | undefined): string | undefined {
  const isSlow = fault?.kind === 'timeout' || (fault?.kind === 'crashed' && !fault.isOfOther);
  return isSlow ? `because the module was restarted: ${sentence(fault.message)}` : undefined;
}

/** Replaces a backend of the graphics card, or a choice that may become one. */
export function replacementOf(
  backend: BackendName | 'auto',
  inUse: BackendName,
  suspicion: string,
): Replacement | undefined {
  if (backend === 'wasm' || backend === 'cpu') return undefined;
  const next = backend === 'auto' ? inUse : NEXT_BACKEND[backend]!;
  const name = backend === 'auto' ? 'The graphics card' : backend;
  const reason = `${name} is not tried again, ${suspicion}`;
  const advice = 'To try it again, choose another backend and then this one.';
  return {
    backend: next,
    fault: `${reason} ${next} replaces it.`,
    problem: `${reason} ${next} is used instead. ${advice}`,
  };
}

/** Ends a text with a full stop. */
export function sentence(text: string): string {
  return text.endsWith('.') ? text : `${text}.`;
}
