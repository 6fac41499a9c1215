import { ProcessingModuleStatus } from '@ubii/proto';

/** Life cycle state of an instance, finer than the status on the wire. [PM-10] [PM-54] */
export type InstanceStatus =
  | 'creating'
  | 'created'
  | 'processing'
  | 'halting'
  | 'halted'
  /** Its sandbox is gone; it waits to be created again. */
  | 'killed'
  | 'recreating'
  /** Given up. */
  | 'failed'
  | 'destroying'
  | 'destroyed';

/** Events that change the status of an instance. */
export type InstanceMove =
  | 'created'
  | 'start'
  | 'halt'
  | 'halted'
  | 'kill'
  | 'recreate'
  | 'fail'
  | 'destroy'
  | 'destroyed';

const MOVES: {
  readonly [S in InstanceStatus]: { readonly [M in InstanceMove]?: InstanceStatus };
} = {
  creating: { created: 'created', fail: 'failed', destroy: 'destroying' },
  created: { start: 'processing', kill: 'killed', destroy: 'destroying' },
  processing: { halt: 'halting', kill: 'killed' },
  halting: { halted: 'halted', kill: 'killed' },
  halted: { start: 'processing', kill: 'killed', destroy: 'destroying' },
  killed: { recreate: 'recreating', fail: 'failed', destroy: 'destroying' },
  recreating: { created: 'created', kill: 'killed', destroy: 'destroying' },
  failed: { destroy: 'destroying' },
  destroying: { destroyed: 'destroyed' },
  destroyed: {},
};

/** The status after a move, or undefined when the move is not legal there. */
export function nextStatus(status: InstanceStatus, move: InstanceMove): InstanceStatus | undefined {
  return MOVES[status][move];
}

const WIRE_STATUS: { readonly [S in InstanceStatus]: ProcessingModuleStatus | undefined } = {
  creating: ProcessingModuleStatus.INITIALIZED,
  created: ProcessingModuleStatus.CREATED,
  processing: ProcessingModuleStatus.PROCESSING,
  halting: ProcessingModuleStatus.PROCESSING,
  halted: ProcessingModuleStatus.HALTED,
  killed: ProcessingModuleStatus.INITIALIZED,
  recreating: ProcessingModuleStatus.INITIALIZED,
  failed: ProcessingModuleStatus.DESTROYED,
  destroying: undefined,
  destroyed: ProcessingModuleStatus.DESTROYED,
};

/** The status as it is told to others; undefined when it is the one before. */
export function wireStatus(status: InstanceStatus): ProcessingModuleStatus | undefined {
  return WIRE_STATUS[status];
}
