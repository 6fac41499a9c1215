import {
  RecordingKind,
  type RecordingSelection,
  type RecordingStudy,
  type TextLimits,
} from '@ubii/proto';
import { hasMoreCharacters, isLongerThan, oneLine, shortened } from '@ubii/words';

import { factsOf, type FileFacts } from './file-facts.ts';
import type { RecordingJob } from './recorder.ts';

/** A selection with all its texts, bytes of JSON: as long as the request that starts a recording may be. */
const MAX_SELECTION_BYTES = 256 * 1024;
/** A selection in a list of recordings. */
const MAX_LISTED_SELECTION_BYTES = 4 * 1024;

/** Facts of a file with texts as long as the master takes them; `problem` names what was cut. [RC-54] */
export function boundFacts(facts: FileFacts, limits: TextLimits): FileFacts {
  const { nameCharacters, descriptionCharacters, eventCharacters, idCharacters } = limits;
  const cut: string[] = [];
  const bound = (what: string, text: string, max: number, shorten = lineOf): string => {
    if (hasMoreCharacters(text, max)) cut.push(what);
    return shorten(text, max);
  };
  const { name, notes, author, masterName, version, selection, study } = facts;
  const bounded = {
    name: bound('name', name, nameCharacters),
    notes: bound('notes', notes, descriptionCharacters, shortened),
    author: bound('author', author, nameCharacters),
    masterName: bound('master', masterName, nameCharacters),
    version: bound('version', version, nameCharacters),
    selection: isTooLong(selection, limits) ? undefined : selection,
  };
  const problems = [
    facts.problem,
    ...(cut.length > 0 ? [`Too long in the file, and cut: ${cut.join(', ')}.`] : []),
    ...(bounded.selection === selection
      ? []
      : ['What was selected is too long in the file, and left out.']),
  ];
  return {
    ...facts,
    ...bounded,
    // An id that is cut would be the id of something else.
    makerId: hasMoreCharacters(facts.makerId, idCharacters) ? '' : facts.makerId,
    replayedRecordingId: hasMoreCharacters(facts.replayedRecordingId, idCharacters)
      ? ''
      : facts.replayedRecordingId,
    study: study && boundStudy(study, limits),
    problem: shortened(problems.filter((text) => text !== '').join(' '), eventCharacters),
  };
}

/** The selection for a list of recordings; undefined when it is long. */
export function listedSelection(
  selection: RecordingSelection | undefined,
): RecordingSelection | undefined {
  return isLongerThan(JSON.stringify(selection ?? {}), MAX_LISTED_SELECTION_BYTES)
    ? undefined
    : selection;
}

function isTooLong(
  selection: RecordingSelection | undefined,
  { textsPerList, topicBytes }: TextLimits,
): boolean {
  if (selection === undefined) return false;
  const lists = Object.values(selection).filter((member) => Array.isArray(member));
  return (
    lists.some((texts) => texts.length > textsPerList) ||
    lists.flat().some((text) => isLongerThan(text, topicBytes)) ||
    isLongerThan(JSON.stringify(selection), MAX_SELECTION_BYTES)
  );
}

function boundStudy(study: RecordingStudy, { nameCharacters }: TextLimits): RecordingStudy {
  const texts = Object.entries(study).map(([member, value]) => [
    member,
    typeof value === 'string' ? lineOf(value, nameCharacters) : value,
  ]);
  return Object.fromEntries(texts) as RecordingStudy;
}

function lineOf(text: string, max: number): string {
  return shortened(oneLine(text, max + 1), max);
}

/**
 * What is kept of what an uploaded file says of itself. What the recording belongs to is not: of the recording of a node,
 * the master knows it; another file belongs to nothing, unless an admin brings back what was part of a study.
 * [RC-41] [RC-63]
 */
export function adoptedFacts(
  job: RecordingJob,
  said: FileFacts,
  nowMs: number,
  limits: TextLimits,
): FileFacts {
  if (job.isOfNode === true) {
    const { author, makerId, study, replayedRecordingId = '' } = job;
    const isComparison = replayedRecordingId !== '';
    const kind = isComparison
      ? RecordingKind.RECORDING_KIND_COMPARISON
      : RecordingKind.RECORDING_KIND_RECORDING;
    const ordered = { author, makerId, study, replayedRecordingId, kind };
    return boundFacts({ ...said, ...ordered }, limits);
  }
  const { notes, personalData } = said;
  const study = job.keepsStudy === true ? said.study : undefined;
  const kept = { ...job, name: job.name || said.name, notes, personalData, study };
  return boundFacts(factsOf(kept, RecordingKind.RECORDING_KIND_IMPORT, nowMs), limits);
}
