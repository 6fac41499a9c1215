import type { ModuleFault, ModuleSource, SandboxFactory } from '@ubii/pm-sandbox';
import type { SessionProblem } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { isJavaScript } from '../../nodes/node.ts';
import { quote } from '../../texts/quote.ts';
import type { DraftModule } from '../complete-modules.ts';
import { errorProblem, warningProblem } from '../problems.ts';
import { about } from './check-context.ts';
import { hasCode } from './check-modules.ts';

/** Dependencies of the check of sources. */
export interface SourceCheckContext {
  readonly sandboxes: SandboxFactory;
  readonly clock: Clock;
  /** All sources of a session are looked at within this time, milliseconds. */
  readonly timeoutMs: number;
}

/** Code that does not parse [SE-4]. Code that was not checked in time is a warning: the node reports errors. */
export async function checkSources(
  modules: readonly DraftModule[],
  { sandboxes, clock, timeoutMs }: SourceCheckContext,
): Promise<SessionProblem[]> {
  const toCheck = modules.filter(
    (draft) => hasCode(draft) && !draft.isLibraryCode && isJavaScript(draft.spec),
  );
  if (toCheck.length === 0) return [];
  let giveUp = (): void => undefined;
  const timeout = new Promise<'late'>((resolve) => {
    giveUp = clock.after(timeoutMs, () => resolve('late'));
  });
  const problems = await Promise.all(
    toCheck.map(async (draft) => {
      const check = sandboxes.check(sourceOf(draft)).catch(() => 'late' as const);
      const fault = await Promise.race([check, timeout]);
      if (fault === undefined) return undefined;
      return fault !== 'late' && isOfSource(fault)
        ? syntaxProblem(draft, fault)
        : notChecked(draft);
    }),
  );
  giveUp();
  return problems.filter((problem) => problem !== undefined);
}

const MEMBERS = {
  onCreated: 'onCreatedStringified',
  onProcessing: 'onProcessingStringified',
  onHalted: 'onHaltedStringified',
  onDestroyed: 'onDestroyedStringified',
} as const;

function sourceOf({ spec }: DraftModule): ModuleSource {
  return {
    onProcessing: spec.onProcessingStringified,
    onCreated: spec.onCreatedStringified || undefined,
    onHalted: spec.onHaltedStringified || undefined,
    onDestroyed: spec.onDestroyedStringified || undefined,
  };
}

/** The fault is in the text, not in the worker that checked it. */
function isOfSource({ kind }: ModuleFault): boolean {
  return kind === 'syntax' || kind === 'missing';
}

function syntaxProblem(draft: DraftModule, fault: ModuleFault): SessionProblem {
  const member = fault.phase === '' ? MEMBERS.onProcessing : MEMBERS[fault.phase];
  const where =
    fault.line === undefined ? '' : ` (line ${fault.line}, column ${fault.column ?? 1})`;
  return errorProblem({
    ...about(draft),
    code: 'syntax',
    message: `The code of the module ${quote(draft.spec.name)} cannot be used: ${fault.message}${where}`,
    path: `${draft.path}.${member}`,
    line: fault.line ?? 0,
    column: fault.column ?? 0,
  });
}

function notChecked(draft: DraftModule): SessionProblem {
  return warningProblem({
    ...about(draft),
    code: 'not_checked',
    message: `The code of the module ${quote(draft.spec.name)} could not be checked in time. Its node reports whether it can be used.`,
    path: `${draft.path}.onProcessingStringified`,
  });
}
