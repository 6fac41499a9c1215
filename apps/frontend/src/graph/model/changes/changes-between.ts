import { identityChanges, moduleIdentity, type IdentityField } from '@ubii/pm-sandbox';
import { isSameValue, type IOMapping, type ProcessingModule, type Session } from '@ubii/proto';
import { modeWords } from '../../../sessions/words/mode-words.ts';
import { graphOf } from '../graph-of.ts';
import {
  readModules,
  type InputEnds,
  type MappedModule,
  type OutputTarget,
} from '../read-mappings.ts';
import { wishedNode } from './wished-node.ts';

/** Effect of a change on a running session [SE-15]: applied live, a module starts, restarts or ends, or none. */
export type ChangeEffect = 'live' | 'start' | 'restart' | 'end' | 'none';

/** Difference between the running and the edited session. */
export interface SessionChange {
  readonly effect: ChangeEffect;
  /** Id of the affected module, if any. */
  readonly moduleId: string | undefined;
  /** One sentence for users. */
  readonly words: string;
}

/** Returns the effects of replacing the running session by the edited one. */
export function changesBetween(running: Session, edited: Session): SessionChange[] {
  const before = new Map(readModules(running).map((module) => [module.nodeId, module]));
  const after = new Map(readModules(edited).map((module) => [module.nodeId, module]));
  const changes: SessionChange[] = [];
  for (const [id, { module }] of before) {
    if (!after.has(id)) changes.push(about(module, 'end', `${nameOf(module)} ends.`));
  }
  for (const [id, next] of after) {
    const old = before.get(id);
    if (old === undefined) {
      changes.push(about(next.module, 'start', `${nameOf(next.module)} starts.`));
    } else changes.push(...moduleChanges(old, next));
  }
  return [...changes, ...sessionChanges(running, edited)];
}

const nameOf = ({ name }: ProcessingModule): string => name || 'A module without a name';

const about = ({ id }: ProcessingModule, effect: ChangeEffect, words: string): SessionChange => ({
  effect,
  moduleId: id,
  words,
});

function* moduleChanges(old: MappedModule, next: MappedModule): Iterable<SessionChange> {
  const { module } = next;
  const name = nameOf(module);
  const reasons = restartReasons(old.module, module);
  if (reasons.length > 0) {
    yield about(module, 'restart', `${name} restarts: ${reasons.join(', ')}.`);
  }
  const mode = modeWords(module.processingMode);
  if (mode !== modeWords(old.module.processingMode)) {
    yield about(module, 'live', `${name} runs ${mode}.`);
  }
  for (const input of new Set([...old.inputs.keys(), ...next.inputs.keys()])) {
    const [was, is] = [inputWords(old.inputs.get(input)), inputWords(next.inputs.get(input))];
    if (was !== is) yield about(module, 'live', `${name} · ${input} is connected to ${is}.`);
  }
  for (const output of new Set([...old.outputs.keys(), ...next.outputs.keys()])) {
    const [was, is] = [outputWords(old.outputs.get(output)), outputWords(next.outputs.get(output))];
    if (was !== is) yield about(module, 'live', `${name} · ${output} goes to ${is}.`);
  }
  if (spreadersOf(old) !== spreadersOf(next)) {
    yield about(module, 'live', `The muxers or demuxers of ${name} change.`);
  }
  if (!isSameValue(notes(old.module), notes(module))) {
    yield about(module, 'none', `The details of ${name} change.`);
  }
}

/** Identity of a module without its session and trust, which only the master knows. */
const identityOf = (module: ProcessingModule): ReturnType<typeof moduleIdentity> =>
  moduleIdentity({ module: { ...module, sessionId: '' }, isTrusted: false });

function restartReason(field: IdentityField, old: ProcessingModule): string {
  if (field === 'name') return `it was ${nameOf(old)}`;
  return field === 'inputs' || field === 'outputs' ? `its ${field} changed` : 'its code changed';
}

/** Returns the reasons why a module must restart. */
function restartReasons(old: ProcessingModule, next: ProcessingModule): string[] {
  const changed = identityChanges(identityOf(old), identityOf(next));
  const reasons = [...new Set(changed.map((field) => restartReason(field, old)))];
  const [was, is] = [wishedNode(old), wishedNode(next)];
  // Choosing the node that already runs the module moves nothing.
  if (was !== is && is !== old.nodeId) {
    reasons.push(is === '' ? 'the master chooses its node' : 'it moves to another node');
  }
  return reasons;
}

const notes = ({ description, tags, authors, extension }: ProcessingModule): unknown => [
  description,
  tags,
  authors,
  extension?.version ?? '',
];

function inputWords(ends: InputEnds | undefined): string {
  const words = (ends?.sources ?? []).map((source) =>
    source.kind === 'topic' ? source.topic : `the muxer ${muxWords(source.mux)}`,
  );
  // A constant is used only when nothing else is mapped to the input. [PM-34]
  if (words.length > 0) return words.join(' and ');
  return ends?.constantJson ? `the constant ${ends.constantJson}` : 'nothing';
}

const muxWords = ({
  topicGlob,
  topicSelector,
  name,
}: NonNullable<IOMapping['inputMappings'][0]['topicMux']>): string =>
  topicGlob || topicSelector || name || 'of components';

function outputWords(targets: readonly OutputTarget[] | undefined): string {
  const words = (targets ?? []).map((target) =>
    target.kind === 'topic' ? target.topic : `the demuxer ${target.demux.outputTopicFormat}`,
  );
  return words.length > 0 ? words.join(' and ') : 'nothing';
}

/** Settings of muxers and demuxers apart from patterns, ids and names, as text for comparison. */
function spreadersOf({ inputs, outputs }: MappedModule): string {
  const muxes = [...inputs].flatMap(([input, { sources }]) =>
    sources.flatMap((source) => {
      if (source.kind !== 'muxer') return [];
      const {
        id: _id,
        name: _name,
        topicGlob: _glob,
        topicSelector: _selector,
        ...rest
      } = source.mux;
      return [[input, rest]];
    }),
  );
  const demuxes = [...outputs].flatMap(([output, targets]) =>
    targets.flatMap((target) =>
      target.kind === 'demuxer' ? [[output, target.demux.dataType]] : [],
    ),
  );
  return JSON.stringify([muxes, demuxes].map((list) => [...list].sort()));
}

function* sessionChanges(running: Session, edited: Session): Iterable<SessionChange> {
  const session = (effect: ChangeEffect, words: string): SessionChange => ({
    effect,
    moduleId: undefined,
    words,
  });
  const [old, next] = [graphOf(running).details, graphOf(edited).details];
  if (old.name !== next.name)
    yield session(
      'none',
      next.name ? `The session is renamed to ${next.name}.` : 'The session has no name.',
    );
  if (old.lockstepHertz !== next.lockstepHertz) {
    const rate =
      next.lockstepHertz === 0 ? 'at the default rate' : `${next.lockstepHertz} times per second`;
    yield session('live', `Lockstep passes run ${rate}.`);
  }
  if (old.startWithMaster !== next.startWithMaster) {
    const words = next.startWithMaster
      ? 'starts with the master'
      : 'does not start with the master';
    yield session('none', `The session ${words}.`);
  }
  const said = ({ description, tags, authors, editable }: typeof old): unknown => [
    description,
    tags,
    authors,
    editable,
  ];
  if (!isSameValue(said(old), said(next)))
    yield session('none', 'The details of the session change.');
  if ((running.extension?.editorJson ?? '') !== (edited.extension?.editorJson ?? '')) {
    yield session('none', 'Layout changed.');
  }
}
