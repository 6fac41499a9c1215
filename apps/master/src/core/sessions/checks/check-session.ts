import type { SessionProblem } from '@ubii/proto';
import { quote } from '../../texts/quote.ts';
import { warningProblem, type ProblemCode } from '../problems.ts';
import { about, type Check, type CheckContext } from './check-context.ts';
import type { DraftModule } from '../complete-modules.ts';
import { checkCycles } from './check-cycles.ts';
import { checkFormats } from './check-formats.ts';
import { checkMappings } from './check-mappings.ts';
import { checkModules } from './check-modules.ts';

/** Topics with more than one writer [SE-5]. */
const checkWriters: Check = function* (modules) {
  const writers = new Map<string, string>();
  for (const draft of modules) {
    for (const [index, { topic }] of draft.mapping.outputMappings.entries()) {
      if (topic === undefined || topic === '') continue;
      const other = writers.get(topic);
      if (other !== undefined) {
        yield warningProblem({
          ...about(draft),
          code: 'topic_written_twice',
          message: `Both ${quote(other)} and ${quote(draft.spec.name)} write ${quote(topic)}. The last value written counts.`,
          path: `${draft.mappingPath}.outputMappings[${index}].topic`,
        });
      }
      writers.set(topic, draft.spec.name);
    }
  }
};

const CHECKS: readonly Check[] = [
  checkModules,
  checkMappings,
  checkFormats,
  checkWriters,
  checkCycles,
];

/** The codes of `checkSurroundings`. */
export const SURROUNDINGS: ReadonlySet<string> = new Set<ProblemCode>([
  'format_mismatch',
  'topic_without_record',
  'topic_of_other_format',
  'node_unavailable',
]);

/** Returns warnings that depend on current topics, components and nodes. */
export function checkSurroundings(
  modules: readonly DraftModule[],
  context: CheckContext,
): SessionProblem[] {
  const ofNodes = modules.flatMap((draft) => {
    const problem = context.nodeProblem(draft);
    return problem === undefined ? [] : [{ ...problem, path: `${draft.path}.nodeId` }];
  });
  return [
    ...checkFormats(modules, context),
    ...ofNodes.filter(({ code }) => SURROUNDINGS.has(code)),
  ].map((problem) => ({ ...problem, isError: false }));
}

/** Problems of these modules that show without running code [SE-3]. */
export function checkSession(
  modules: readonly DraftModule[],
  context: CheckContext,
): SessionProblem[] {
  return CHECKS.flatMap((check) => [...check(modules, context)]);
}
