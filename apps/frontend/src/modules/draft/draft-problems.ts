import { DEFAULT_RUNTIME_LIMITS, moduleProblems } from '@ubii/pm-sandbox';
import { parseDataFormat } from '@ubii/proto';
import { defaultProblem } from './io-default.ts';
import { splitText } from '../text/module-text.ts';
import { moduleOf, type ModuleDraft } from './module-draft.ts';

/** Problems in the fields of a draft: a sentence by path, such as `inputs[0].name`. */
export type DraftProblems = ReadonlyMap<string, string>;

const IDENTIFIER = /^[\p{ID_Start}$_][\p{ID_Continue}$]*$/u;
/** Highest frequency that the runtime supports. [PM-20] */
export const MAX_HERTZ = DEFAULT_RUNTIME_LIMITS.maxFrequencyHz;

/**
 * @param taken names of other modules
 * @param text the code of the draft, when it is split already
 */
export function draftProblems(
  draft: ModuleDraft,
  taken: ReadonlySet<string>,
  text = splitText(draft.code),
): DraftProblems {
  const problems = new Map<string, string>();
  for (const { path, message } of moduleProblems(moduleOf(draft, text))) {
    const place = path.replace('.internalName', '.name');
    // Problems of the code are shown in the code.
    if (place !== 'onProcessingStringified' && !problems.has(place)) problems.set(place, message);
  }
  const name = draft.name.trim();
  if (name !== '' && taken.has(name)) {
    problems.set('name', `A module named ${name} exists. Choose another name.`);
  }
  for (const side of ['inputs', 'outputs'] as const) {
    draft[side].forEach((io, index) => {
      const place = `${side}[${index}]`;
      if (io.name !== '' && !IDENTIFIER.test(io.name) && !problems.has(`${place}.name`)) {
        problems.set(
          `${place}.name`,
          'Use letters, digits and _ only: the name is an identifier in the code.',
        );
      }
      if (io.format !== '' && parseDataFormat(io.format) === undefined) {
        problems.set(
          `${place}.format`,
          `${io.format} is not a data format. Records of any format pass.`,
        );
      }
    });
  }
  draft.inputs.forEach((io, index) => {
    const problem = defaultProblem(io);
    if (problem !== undefined) problems.set(`inputs[${index}].default`, problem);
  });
  const { kind, hertz, minDelayMs } = draft.mode;
  if (kind === 'frequency' && !(hertz > 0 && hertz <= MAX_HERTZ)) {
    problems.set('mode.hertz', `Enter a frequency above 0 and up to ${MAX_HERTZ} Hz, such as 30.`);
  }
  if (kind === 'trigger' && !(minDelayMs >= 0)) {
    problems.set('mode.minDelayMs', 'Enter 0 ms or more.');
  }
  return problems;
}

/** Unknown formats are allowed. [PM-3] */
export function isFatalProblem(place: string): boolean {
  return !place.endsWith('.format');
}
