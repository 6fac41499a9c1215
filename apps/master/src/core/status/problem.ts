import type { StatusProblem } from '@ubii/proto';

/** Something that is wrong now; what is not given is empty [EX-18]. */
export type Problem = Pick<StatusProblem, 'code' | 'severity' | 'text' | 'sinceMs'> &
  Partial<StatusProblem>;
