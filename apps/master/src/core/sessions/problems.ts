import type { SessionProblem } from '@ubii/proto';

/** Problems of a session, a closed list [SE-4] [SE-5] [SE-12]. */
export type ProblemCode =
  // Errors of a specification.
  | 'module_without_name'
  | 'module_unknown'
  | 'syntax'
  | 'missing_callback'
  | 'name_twice'
  | 'name_empty'
  | 'mapping_without_module'
  | 'unknown_input'
  | 'unknown_output'
  | 'mapped_twice'
  | 'list_expected'
  | 'list_unexpected'
  | 'format_mismatch'
  | 'bad_expression'
  | 'demux_without_placeholder'
  | 'forbidden_topic'
  | 'bad_topic'
  | 'bad_constant'
  | 'unknown_node'
  | 'node_cannot_run'
  | 'endless_cycle'
  // Warnings.
  | 'cycle'
  | 'topic_written_twice'
  | 'topic_without_record'
  | 'topic_of_other_format'
  | 'not_checked'
  | 'node_unavailable'
  // While it lives.
  | 'module_not_started'
  | 'module_failed'
  | 'module_run_failed'
  | 'module_not_stopped'
  | 'node_gone'
  | 'node_cannot_pause'
  | 'node_cannot_update'
  | 'module_not_reloaded'
  | 'node_without_lockstep'
  | 'node_late'
  | 'too_many_topics';

/** One problem as it is found; what is not given is empty. */
export type ProblemInit = { readonly code: ProblemCode; readonly message: string } & Partial<
  Omit<SessionProblem, 'code' | 'message'>
>;

/** Something that keeps the session from running as it should. */
export function errorProblem(problem: ProblemInit): SessionProblem {
  return { ...EMPTY, ...problem, isError: true };
}

/** Something that people should know [SE-5]. */
export function warningProblem(problem: ProblemInit): SessionProblem {
  return { ...EMPTY, ...problem, isError: false };
}

/** Errors first, else in the order they were found. */
export function sortProblems(problems: readonly SessionProblem[]): SessionProblem[] {
  return [
    ...problems.filter((problem) => problem.isError),
    ...problems.filter((problem) => !problem.isError),
  ];
}

const EMPTY: SessionProblem = {
  isError: false,
  code: '',
  message: '',
  path: '',
  moduleId: '',
  moduleName: '',
  nodeId: '',
  line: 0,
  column: 0,
};
