import type { ModuleIO, SessionProblem } from '@ubii/proto';
import { isLongerThan } from '@ubii/words';
import { quote } from '../../texts/quote.ts';
import type { DraftModule } from '../complete-modules.ts';
import { errorProblem } from '../problems.ts';
import { about, type Check, type CheckContext } from './check-context.ts';

/** Each module by itself: name, code, inputs and outputs, node [SE-4]. */
export const checkModules: Check = function* (modules, context) {
  for (const draft of modules) {
    yield* checkName(draft);
    yield* checkCode(draft, context);
    yield* checkNames(draft, 'inputs');
    yield* checkNames(draft, 'outputs');
    const problem = context.nodeProblem(draft);
    if (problem !== undefined) yield { ...problem, path: `${draft.path}.nodeId` };
  }
};

function* checkName(draft: DraftModule): Iterable<SessionProblem> {
  if (draft.spec.name !== '') return;
  yield errorProblem({
    ...about(draft),
    code: 'module_without_name',
    message: 'The module has no name. Give it a name, so that nodes and mappings can refer to it.',
    path: `${draft.path}.name`,
  });
}

const CALLBACKS = [
  'onProcessingStringified',
  'onCreatedStringified',
  'onHaltedStringified',
  'onDestroyedStringified',
] as const;

function* checkCode(draft: DraftModule, context: CheckContext): Iterable<SessionProblem> {
  const { spec, path, requestedNodeId } = draft;
  if (!hasCode(draft)) {
    const hasOther = CALLBACKS.some((callback) => spec[callback] !== '');
    if (hasOther) {
      yield errorProblem({
        ...about(draft),
        code: 'missing_callback',
        message: `The module ${quote(spec.name)} has callbacks, but no onProcessing, which every module needs.`,
        path: `${path}.onProcessingStringified`,
      });
    } else if (requestedNodeId === undefined && spec.name !== '' && !context.isOffered(spec.name)) {
      yield errorProblem({
        ...about(draft),
        code: 'module_unknown',
        message: `The module ${quote(spec.name)} has no code, and neither the library nor a node has a module of that name. Send its code, or start a node that has it.`,
        path,
      });
    }
  }
}

/** Whether all callbacks together take more bytes than that [PM-57]. */
export function isSourceLongerThan({ spec }: DraftModule, maxBytes: number): boolean {
  const source = CALLBACKS.map((callback) => spec[callback]).join('');
  return isLongerThan(source, maxBytes);
}

/** [PM-3] */
function* checkNames(draft: DraftModule, list: 'inputs' | 'outputs'): Iterable<SessionProblem> {
  const seen = new Set<string>();
  for (const [index, { internalName }] of draft.spec[list].entries()) {
    const path = `${draft.path}.${list}[${index}].internalName`;
    if (internalName === '') {
      yield errorProblem({
        ...about(draft),
        code: 'name_empty',
        message: `One of the ${list} of the module ${quote(draft.spec.name)} has no internal name.`,
        path,
      });
    } else if (seen.has(internalName)) {
      yield errorProblem({
        ...about(draft),
        code: 'name_twice',
        message: `The module ${quote(draft.spec.name)} has two ${list} named ${quote(internalName)}; names are unique among the ${list}.`,
        path,
      });
    }
    seen.add(internalName);
  }
}

export function hasCode({ spec }: DraftModule): boolean {
  return spec.onProcessingStringified.trim() !== '';
}

/** The input or output of this name. */
export function ioOf(list: readonly ModuleIO[], name: string): ModuleIO | undefined {
  return list.find(({ internalName }) => internalName === name);
}
