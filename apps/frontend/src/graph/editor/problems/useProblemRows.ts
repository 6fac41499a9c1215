import { computed, type ComputedRef } from 'vue';
import { useConnection } from '../../../connection/useConnection.ts';
import { RUN_FAILED, runProblems } from '../../../sessions/live/run-problems.ts';
import type { SessionRef } from '../../../sessions/words/shared-topics.ts';
import { useGraphContext, type GraphContext } from '../../live/useGraphContext.ts';
import { useGraphProblems, type LiveProblems } from '../../live/useGraphProblems.ts';
import { moduleNodeId } from '../../model/make-node.ts';
import type { Remedy } from '../../model/live/graph-problem.ts';
import { nodeTitle } from '../../nodes/node-label.ts';

/** A problem of the session or of the runs of its modules. */
export interface ProblemRow {
  readonly isError: boolean;
  /** One sentence. */
  readonly message: string;
  /** Title of the node, unless the sentence has it. */
  readonly subject: string | undefined;
  /** Node that has it; undefined for the session as a whole. */
  readonly node: string | undefined;
  /** Number of occurrences. */
  readonly count: number;
  /** Position in the code of a module. */
  readonly code: { readonly moduleName: string; readonly at: string } | undefined;
  readonly remedy: Remedy | undefined;
  readonly others: readonly SessionRef[];
}

/** Problems of the session, of saved and unsaved changes, and of runs; those of runs come first. */
export function useProblemRows(
  { editor, live }: Pick<GraphContext, 'editor' | 'live'> = useGraphContext(),
  { problems }: Pick<LiveProblems, 'problems'> = useGraphProblems(),
): ComputedRef<readonly ProblemRow[]> {
  const { topics } = useConnection();
  const running = computed(() =>
    runProblems(editor.session.value, live.events.value, topics.masterTimeMs.value),
  );

  function placed(id: string | undefined, message: string): Pick<ProblemRow, 'node' | 'subject'> {
    const node = id === undefined ? undefined : editor.graph.value.nodes.get(id);
    const title = node && nodeTitle(node);
    const isSaid = title === undefined || message.includes(`"${title}"`);
    return { node: node?.id, subject: isSaid ? undefined : title };
  }

  return computed(() => {
    const ofRuns = running.value.map((problem): ProblemRow => {
      const { message, isError, moduleId, moduleName, line, column } = problem;
      return {
        isError,
        message,
        ...placed(moduleNodeId(moduleId), message),
        count: problem.count ?? 1,
        // Runs fail in it; what fails elsewhere says no line.
        code:
          line > 0 ? { moduleName, at: `onProcessing:${line}:${Math.max(1, column)}` } : undefined,
        remedy: undefined,
        others: [],
      };
    });
    const told = new Set(ofRuns.map(({ node }) => node));
    const ofGraph = problems.value.all
      .filter(({ code, node }) => code !== RUN_FAILED || !told.has(node))
      .map(({ isError, message, node, remedy, others = [] }): ProblemRow => ({
        isError,
        message,
        ...placed(node, message),
        count: 1,
        code: undefined,
        remedy,
        others,
      }));
    return [...ofRuns, ...ofGraph];
  });
}
