/** A callback of a module; empty when something went wrong outside of them. */
export type ModulePhase = '' | 'onCreated' | 'onProcessing' | 'onHalted' | 'onDestroyed';

/**
 * User code failed. A value, never thrown across the runtime's border:
 * `syntax` does not parse, `missing` lacks onProcessing, `threw` an exception, `timeout` and `memory`
 * killed for it, `output` cannot be published, `flood` over a rate, `library` not offered by the node,
 * `crashed` its worker ended, `record` an input does not fit.
 */
export type ModuleFaultKind =
  | 'syntax'
  | 'missing'
  | 'threw'
  | 'timeout'
  | 'memory'
  | 'output'
  | 'flood'
  | 'library'
  | 'crashed'
  | 'record';

/** A failure of a module and its place. */
export interface ModuleFault {
  readonly kind: ModuleFaultKind;
  readonly phase: ModulePhase;
  /** One sentence. */
  readonly message: string;
  /** Line in the source of the callback, from 1. */
  readonly line?: number | undefined;
  /** Column in that line, from 1. */
  readonly column?: number | undefined;
  /** With `output` and `flood`: the values it stands for, 1 unless given. */
  readonly count?: number | undefined;
  /** With `crashed`: another module made the worker end that they shared. */
  readonly isOfOther?: boolean | undefined;
  /** With `memory`: the memory of all modules of the node is used up, or that of its session. [PM-58] */
  readonly shortage?: 'all' | 'owner' | undefined;
}
