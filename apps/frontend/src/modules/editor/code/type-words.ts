import { exampleOf, undeclaredName } from '@ubii/pm-sandbox';
import { parseDataFormat } from '@ubii/proto';
import type { ModuleDraft } from '../../draft/module-draft.ts';

const NAMED = /types of 'outputs\.([^']+)' are incompatible/;
const MISFIT = /^Type '(.+)' is not assignable to type '(OutputValue|OutputList)<"(\w+)">/;
const LACKING =
  /^Property 'elements' is missing in type '(.+)' but required in type '(OutputList)<"(\w+)">/;
const EXTRA = /'([^']+)' does not exist in type '(OutputValue|OutputList)<"(\w+)">/;
const UNKNOWN_OUTPUT = /'([^']+)' does not exist in type 'Outputs'/;
const NO_OUTPUT = /^Type '\{ ([\w$]+)\??: .*' has no properties in common with type 'Outputs'/;
const UNKNOWN_INPUT = /^Property '([^']+)' does not exist on type 'Inputs'/;
const NO_VALUE = /^'([^']+)' is possibly 'undefined'/;
const NO_RESULT =
  /^Type '(.+)' is not assignable to type 'void \| Result \| Promise<void \| Result>'/;

type Declared = Pick<ModuleDraft, 'inputs' | 'outputs'>;

/** Rewrites a message of TypeScript in terms of the module's inputs and outputs, as a run would report it. */
export function typeWords(message: string, { inputs, outputs }: Declared): string {
  const lines = message.split('\n').map((line) => line.trim());
  const find = (pattern: RegExp): RegExpExecArray | undefined => {
    for (const line of lines) {
      const match = pattern.exec(line);
      if (match !== null) return match;
    }
    return undefined;
  };
  const names = (list: Declared['inputs']): string[] => list.map(({ name }) => name);
  const output = find(UNKNOWN_OUTPUT) ?? find(NO_OUTPUT);
  if (output !== undefined) return undeclaredName('Output', output[1]!, names(outputs));
  const input = find(UNKNOWN_INPUT);
  if (input !== undefined) return undeclaredName('Input', input[1]!, names(inputs));
  const misfit = find(MISFIT) ?? find(LACKING);
  if (misfit !== undefined) return outputWords(find(NAMED)?.[1], misfit, written(misfit[1]!));
  const extra = find(EXTRA);
  if (extra !== undefined) return outputWords(undefined, extra, `{ ${extra[1]!} }`);
  const empty = find(NO_VALUE);
  if (empty?.[1]?.startsWith('inputs.')) {
    return `${empty[1]} has no value until the first record. Return before you read it: if (!${empty[1]}) return;`;
  }
  const result = lines.length === 1 ? find(NO_RESULT) : undefined;
  if (result === undefined) return message;
  return `onProcessing must return { outputs: { … } }, not ${written(result[1]!)}.`;
}

function outputWords(
  name: string | undefined,
  [, , kind, text]: RegExpExecArray,
  got: string,
): string {
  const format = parseDataFormat(text ?? '');
  const element = format === undefined ? 'its data format' : exampleOf(format);
  const example = kind === 'OutputList' ? `{ elements: [${element}, …] }` : element;
  const sentence = `rite ${example}, not ${got}.`;
  return name === undefined ? `W${sentence}` : `Output "${name}": w${sentence}`;
}

/** Formats a type as the value that was written. */
function written(type: string): string {
  if (type === 'number' || type === 'string' || type === 'boolean') return `a bare ${type}`;
  if (type.endsWith('[]')) return 'an array';
  if (type.startsWith('Promise<')) return 'a promise';
  const members = /^\{ (.*) \}$/.exec(type)?.[1];
  if (members === undefined) return type;
  const [first = ''] = members.split(':');
  return members.includes(';') && members.split(';').length > 2
    ? `{ ${first}, … }`
    : `{ ${first} }`;
}
