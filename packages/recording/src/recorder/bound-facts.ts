import type { RecordingSelection, RecordingStudy, TextLimits } from '@ubii/proto';
import { hasMoreCharacters, isLongerThan, oneLine, shortened } from '@ubii/words';
import type { FileFacts } from './file-facts.ts';

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
