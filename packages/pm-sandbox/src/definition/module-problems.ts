import {
  parseDataFormat,
  ProcessingModuleLanguage,
  type ModuleIO,
  type ProcessingModule,
} from '@ubii/proto';
import { MAX_SOURCE_BYTES } from '../sandbox-limits.ts';
import { MAX_CHOICE_CHARACTERS, MAX_CHOICES, MAX_IO_DESCRIPTION_CHARACTERS } from './io-limits.ts';

/** Something wrong with a module. */
export interface ModuleProblem {
  /** Path, such as `inputs[1].internalName`; empty for the module as a whole. */
  readonly path: string;
  /** One sentence. */
  readonly message: string;
}

const CALLBACKS = [
  'onCreatedStringified',
  'onProcessingStringified',
  'onHaltedStringified',
  'onDestroyedStringified',
] as const;

/**
 * All that can be said against a module without running it. Formats that are not known are no
 * problem. [PM-3] [PM-57]
 *
 * @returns empty when it is fine
 */
export function moduleProblems(module: ProcessingModule): ModuleProblem[] {
  const problems: ModuleProblem[] = [];
  if (module.name.trim() === '') problems.push({ path: 'name', message: 'A module needs a name.' });
  checkNames(module.inputs, 'inputs', 'input', problems);
  checkNames(module.outputs, 'outputs', 'output', problems);
  checkDescriptions(module.inputs, 'inputs', problems);
  checkDescriptions(module.outputs, 'outputs', problems);
  module.inputs.forEach((input, i) => checkChoices(input, `inputs[${i}].choices`, problems));
  module.outputs.forEach(({ choices }, i) => {
    if (choices.length === 0) return;
    const message = 'Only inputs have choices. Remove the choices of the output.';
    problems.push({ path: `outputs[${i}].choices`, message });
  });
  checkSource(module, problems);
  return problems;
}

function checkNames(
  ios: readonly ModuleIO[],
  path: string,
  kind: string,
  problems: ModuleProblem[],
): void {
  const seen = new Map<string, number>();
  ios.forEach(({ internalName }, i) => {
    const at = `${path}[${i}].internalName`;
    if (internalName === '') {
      problems.push({ path: at, message: `The ${kind} has no internal name.` });
      return;
    }
    const first = seen.get(internalName);
    if (first === undefined) seen.set(internalName, i);
    else {
      const message = `Two ${kind}s are named "${internalName}". The first is ${path}[${first}].`;
      problems.push({ path: at, message });
    }
  });
}

function checkDescriptions(
  ios: readonly ModuleIO[],
  path: string,
  problems: ModuleProblem[],
): void {
  ios.forEach(({ description: { length } }, i) => {
    if (length <= MAX_IO_DESCRIPTION_CHARACTERS) return;
    const message = `The description has ${length} characters; the limit is ${MAX_IO_DESCRIPTION_CHARACTERS}.`;
    problems.push({ path: `${path}[${i}].description`, message });
  });
}

/** [PM-7] */
function checkChoices(
  { messageFormat, isRecordList, choices }: ModuleIO,
  path: string,
  problems: ModuleProblem[],
): void {
  if (choices.length === 0) return;
  const twice = choices.find((choice, i) => choices.indexOf(choice) !== i);
  const long = choices.find(({ length }) => length > MAX_CHOICE_CHARACTERS);
  const add = (message: string): number => problems.push({ path, message });
  if (parseDataFormat(messageFormat) !== 'string' || isRecordList) {
    add('Only an input for one string has choices. Change its format, or remove the choices.');
  } else if (choices.length > MAX_CHOICES) {
    add(`The input has ${choices.length} choices; the limit is ${MAX_CHOICES}.`);
  } else if (choices.includes('')) {
    add('A choice is empty. Remove it; an empty text can be the default of the input.');
  } else if (twice !== undefined) {
    add(`The choice "${twice.slice(0, MAX_CHOICE_CHARACTERS)}" is there twice. Remove one.`);
  } else if (long !== undefined) {
    add(`A choice has ${long.length} characters; the limit is ${MAX_CHOICE_CHARACTERS}.`);
  }
}

function checkSource(module: ProcessingModule, problems: ModuleProblem[]): void {
  const given = CALLBACKS.filter((member) => module[member].trim() !== '');
  if (given.length === 0) return;
  // Clients that mean no language send the number of C++.
  const isJavaScript =
    module.language === ProcessingModuleLanguage.JS ||
    module.language === ProcessingModuleLanguage.CPP;
  if (isJavaScript && !given.includes('onProcessingStringified')) {
    const message = `A module with ${given[0]} also needs onProcessingStringified.`;
    problems.push({ path: 'onProcessingStringified', message });
  }
  const sizeBytes = given.reduce((sum, member) => sum + utf8Length(module[member]), 0);
  if (sizeBytes > MAX_SOURCE_BYTES) {
    const message = `The source of the module has ${sizeBytes} bytes; the limit is ${MAX_SOURCE_BYTES} bytes.`;
    problems.push({ path: '', message });
  }
}

/** Bytes of a text in UTF-8, without making them. */
function utf8Length(text: string): number {
  let bytes = text.length;
  for (let i = 0; i < text.length; i++) {
    const unit = text.charCodeAt(i);
    if (unit < 0x80) continue;
    // A surrogate is half of a character of four bytes.
    bytes += unit < 0x800 || (unit >= 0xd800 && unit <= 0xdfff) ? 1 : 2;
  }
  return bytes;
}
