import type { StatusProblem } from '@ubii/proto';

/** Problems of a master; docs/errors.md explains each. */
export type MasterProblemCode =
  | 'client_silent'
  | 'client_slow'
  | 'client_throttled'
  | 'protocol_errors'
  | 'limit_reached'
  | 'file_broken'
  | 'session_degraded'
  | 'master_busy'
  | 'machine_busy'
  | 'publisher_noisy'
  | 'module_slow'
  | 'cluster_unreachable';

/** Something that is wrong now; what is not given is empty [EX-18]. */
export type Problem = { readonly code: MasterProblemCode } & Pick<
  StatusProblem,
  'severity' | 'text' | 'sinceMs'
> &
  Partial<Omit<StatusProblem, 'code'>>;
