import {
  DATA_FORMATS,
  encode,
  isDataFormat,
  timestampFromMs,
  type DataFormat,
  type DataFormatInfo,
  type Init,
  type Timestamp,
  type TopicDataRecord,
} from '@ubii/proto';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxOutput, SandboxRequest, SandboxValue } from '../ports/sandbox.ts';
import { describeThrown, moduleFault } from './module-error.ts';
import { AWAIT_ADVICE, exampleOf, kindOf, shownMembers, unsendableKind } from './value-words.ts';

/** Value of one output; undefined without one. */
export type RawOutput =
  | { readonly name: string; readonly value: unknown }
  /** It could not be taken out: a sentence why. [PM-56] */
  | { readonly name: string; readonly problem: string };

/** One output as it is declared. */
export type DeclaredOutput = SandboxRequest['outputs'][number];

/** The outputs of one run and what was refused of them. */
export interface EncodedOutputs {
  readonly outputs: SandboxOutput[];
  readonly faults: ModuleFault[];
}

/** Refusals of one run that are told one by one. */
const MAX_FAULTS = 20;

/** Members beside the value that a module may write. */
const SIDE_MEMBERS: ReadonlySet<string> = new Set([
  'topic',
  'type',
  'clientId',
  'timestamp',
  'identity',
  'outputTopicParams',
  'output_params',
]);

type Element = Extract<SandboxOutput, { elements: unknown }>['elements'][number];

/** A part of an output that is refused; the others go on. */
class Refused extends Error {}

/** The bytes of one run are used up. */
class Flood extends Error {}

/**
 * Checks and encodes what a module put out. A bad output or element does not lose the others. Equal
 * mistakes of the elements of an output are told once.
 * [PM-32] [PM-33] [PM-45] [PM-56]
 *
 * @param limitBytes of all values of the run
 */
export function encodeOutputs(
  declared: readonly DeclaredOutput[],
  raw: readonly RawOutput[],
  limitBytes: number,
): EncodedOutputs {
  const outputs: SandboxOutput[] = [];
  const faults: ModuleFault[] = [];
  let leftBytes = limitBytes;

  /** @throws Flood when the run has no bytes left for it */
  const fit = (value: SandboxValue): SandboxValue => {
    if (value.bytes.byteLength > leftBytes) {
      throw new Flood(`the outputs of one run exceed the limit of ${limitBytes} bytes.`);
    }
    leftBytes -= value.bytes.byteLength;
    return value;
  };

  for (const entry of raw) {
    const output = declared.find(({ name }) => name === entry.name);
    if (output === undefined) continue;
    const { name, format } = output;
    const title = `Output "${name}"`;
    if ('problem' in entry) {
      faults.push(moduleFault('output', 'onProcessing', `${title}: ${entry.problem}`));
      continue;
    }
    if (entry.value === undefined || entry.value === null) continue;
    const list = elementsOf(entry.value, format);
    if (list !== undefined) {
      const encoded = encodeElements(list, format, title, fit);
      outputs.push({ name, elements: encoded.elements });
      faults.push(...encoded.faults);
      continue;
    }
    try {
      outputs.push({ name, value: fit(encodeValue(entry.value, format)) });
    } catch (thrown) {
      faults.push(faultFor(title, thrown));
    }
  }
  return { outputs, faults: shorten(faults) };
}

function encodeElements(
  list: readonly unknown[],
  format: DataFormat | undefined,
  title: string,
  fit: (value: SandboxValue) => SandboxValue,
): { readonly elements: Element[]; readonly faults: ModuleFault[] } {
  const elements: Element[] = [];
  const mistakes = new Map<string, { readonly fault: ModuleFault; count: number }>();
  for (let index = 0; index < list.length; index++) {
    const element: unknown = list[index];
    try {
      const target = targetOf(element);
      elements.push({ value: fit(encodeValue(element, format)), ...target, index });
    } catch (thrown) {
      const known = mistakes.get(reasonOf(thrown));
      if (known !== undefined) known.count++;
      else {
        const fault = faultFor(`${title}, element ${index}`, thrown);
        mistakes.set(reasonOf(thrown), { fault, count: 1 });
      }
    }
  }
  const faults = [...mistakes.values()].map(({ fault, count }) => withCount(fault, count));
  return { elements, faults };
}

function withCount(fault: ModuleFault, count: number): ModuleFault {
  if (count === 1) return fault;
  const more = count === 2 ? '1 more element' : `${count - 1} more elements`;
  return { ...fault, count, message: `${fault.message} The same applies to ${more}.` };
}

function faultFor(title: string, thrown: unknown): ModuleFault {
  const kind = thrown instanceof Flood ? 'flood' : 'output';
  return moduleFault(kind, 'onProcessing', `${title}: ${reasonOf(thrown)}`);
}

function reasonOf(thrown: unknown): string {
  return thrown instanceof Refused || thrown instanceof Flood
    ? thrown.message
    : describeThrown(thrown);
}

function shorten(faults: ModuleFault[]): ModuleFault[] {
  if (faults.length <= MAX_FAULTS) return faults;
  const left = faults.slice(MAX_FAULTS).reduce((sum, { count = 1 }) => sum + count, 0);
  const message = `${left} more values of this run do not fit their outputs.`;
  const rest = { ...moduleFault('output', 'onProcessing', message), count: left };
  return [...faults.slice(0, MAX_FAULTS), rest];
}

/** The list in `{ elements: […] }`, unless the value has the member of its format beside it. */
function elementsOf(value: unknown, format: DataFormat | undefined): unknown[] | undefined {
  if (typeof value !== 'object' || value === null || !('elements' in value)) return undefined;
  const { elements } = value;
  if (!Array.isArray(elements)) return undefined;
  const hasMember = format === undefined ? memberOf(value) !== undefined : format in value;
  return hasMember ? undefined : elements;
}

/** Returns the target of an element; Python modules write `output_params`. [PM-46] [PM-48] */
function targetOf(element: unknown): Pick<Element, 'params' | 'identity'> {
  if (typeof element !== 'object' || element === null)
    return { params: undefined, identity: undefined };
  const { outputTopicParams, output_params, identity } = element as Record<string, unknown>;
  const params = outputTopicParams ?? output_params ?? undefined;
  if (params !== undefined && !Array.isArray(params)) {
    throw new Refused(`outputTopicParams must be an array, not ${kindOf(params)}.`);
  }
  return {
    params: params?.map(parameterText),
    identity: identity === undefined || identity === null ? undefined : parameterText(identity),
  };
}

function parameterText(value: unknown): string {
  if (typeof value === 'string') return value;
  if (typeof value === 'number' || typeof value === 'boolean') return String(value);
  throw new Refused(`outputTopicParams and identity must contain strings, not ${kindOf(value)}.`);
}

function encodeValue(source: unknown, format: DataFormat | undefined): SandboxValue {
  if (unsendableKind(source) === 'a promise') throw promised();
  const isObject = typeof source === 'object' && source !== null;
  const member = format ?? (isObject ? memberOf(source) : undefined);
  if (!isObject || member === undefined || !Object.hasOwn(source, member)) {
    throw new Refused(`${adviceFor(format)}, not ${writtenKind(source)}.`);
  }
  const value = (source as Record<string, unknown>)[member];
  if (value === undefined || value === null) {
    throw new Refused(`${member} is ${String(value)}. Write ${exampleOf(member)}.`);
  }
  const unsendable = unsendableKind(value);
  if (unsendable === 'a promise') throw promised();
  if (unsendable !== undefined) {
    throw new Refused(`${member} is ${unsendable}. Write ${exampleOf(member)}.`);
  }
  const info: DataFormatInfo = DATA_FORMATS[member];
  const problem = info.validate(value);
  if (problem !== undefined) throw new Refused(problem.replace(/got Symbol\((\w+)\)/, 'got a $1'));
  const timestamp = timestampOf((source as { timestamp?: unknown }).timestamp);
  const record: Record<string, unknown> = { timestamp, [member]: value };
  return {
    bytes: encode('ubii.topicData.TopicDataRecord', record as Init<TopicDataRecord>),
    valueField: info.fieldNumber,
    hasTimestamp: timestamp !== undefined,
  };
}

function promised(): Refused {
  return new Refused(`the value is a promise. ${AWAIT_ADVICE}`);
}

function adviceFor(format: DataFormat | undefined): string {
  if (format !== undefined) return `write ${exampleOf(format)}`;
  return `write the value under the name of its data format, such as ${exampleOf('double')}`;
}

/** Describes what was written in place of a value, without the members that may stand beside one. */
function writtenKind(source: unknown): string {
  if (typeof source !== 'object' || source === null || Array.isArray(source)) return kindOf(source);
  const names = Object.keys(source).filter((name) => !SIDE_MEMBERS.has(name));
  return names.length === 0 ? 'an empty object' : shownMembers(names);
}

/** The one member that is a data format, for outputs of an unknown format. [PM-3] */
function memberOf(source: object): DataFormat | undefined {
  return Object.keys(source).find(isDataFormat);
}

/** A timestamp as the wire has it, or milliseconds since the epoch. [PM-32] */
function timestampOf(given: unknown): Init<Timestamp> | undefined {
  if (given === undefined || given === null) return undefined;
  if (typeof given === 'number' && Number.isFinite(given)) return timestampFromMs(given);
  if (typeof given !== 'object')
    throw new Refused('timestamp must be an object with millis, or milliseconds since 1970.');
  const stamp: Record<string, number> = {};
  for (const part of ['seconds', 'nanos', 'millis'] as const) {
    const number = (given as Record<string, unknown>)[part];
    if (number === undefined || number === null) continue;
    if (typeof number !== 'number' || !Number.isSafeInteger(Math.floor(number))) {
      throw new Refused(`timestamp.${part} must be a number.`);
    }
    stamp[part] = Math.floor(number);
  }
  return stamp;
}
