import type { SessionProblem } from '@ubii/proto';
import type { DraftModule } from '../draft.ts';
import type { ProblemCode } from '../problems.ts';
import { checkCycles } from './check-cycles.ts';
import { checkFormats } from './check-formats.ts';
import { checkMappings } from './check-mappings.ts';
import { checkModules } from './check-modules.ts';
import { checkOutputs } from './check-outputs.ts';
import type { Check, CheckContext } from './check-context.ts';

const CHECKS: readonly Check[] = [
  checkModules,
  checkMappings,
  checkFormats,
  checkOutputs,
  checkCycles,
];

/** What is doubtful today and may not be tomorrow: it depends on topics and components. */
export function checkSurroundings(
  modules: readonly DraftModule[],
  context: CheckContext,
): SessionProblem[] {
  return [...checkFormats(modules, context)].map((problem) => ({ ...problem, isError: false }));
}

/** The codes of `checkSurroundings`. */
export const SURROUNDINGS: ReadonlySet<string> = new Set<ProblemCode>([
  'format_mismatch',
  'topic_without_record',
  'topic_of_other_format',
]);

/** Everything that is wrong or doubtful with these modules, as far as it can be said without running code [SE-3]. */
export function checkSession(
  modules: readonly DraftModule[],
  context: CheckContext,
): SessionProblem[] {
  return CHECKS.flatMap((check) => [...check(modules, context)]);
}
