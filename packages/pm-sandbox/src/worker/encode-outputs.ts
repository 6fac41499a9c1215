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

/** What a module gave for one of its outputs; undefined when nothing. */
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

type Element = Extract<SandboxOutput, { elements: unknown }>['elements'][number];

/** A part of an output that is refused; the others go on. */
class Refused extends Error {}

/**
 * Checks and encodes what a module put out. A bad output or element does not lose the others.
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

  /** Undefined when the value is refused, which is reported. */
  const take = (name: string, make: () => SandboxValue): SandboxValue | undefined => {
    try {
      const value = make();
      if (value.bytes.byteLength <= leftBytes) {
        leftBytes -= value.bytes.byteLength;
        return value;
      }
      const message = `${name} is refused: the outputs of one run may have ${limitBytes} bytes.`;
      faults.push(moduleFault('flood', 'onProcessing', message));
    } catch (thrown) {
      const why = thrown instanceof Refused ? thrown.message : describeThrown(thrown);
      faults.push(moduleFault('output', 'onProcessing', `${name} is refused: ${why}`));
    }
    return undefined;
  };

  for (const entry of raw) {
    const output = declared.find(({ name }) => name === entry.name);
    if (output === undefined) continue;
    const title = `Output "${output.name}"`;
    if ('problem' in entry) {
      faults.push(moduleFault('output', 'onProcessing', `${title} is refused: ${entry.problem}`));
      continue;
    }
    if (entry.value === undefined || entry.value === null) continue;
    const list = elementsOf(entry.value, output.format);
    if (list === undefined) {
      const value = take(title, () => encodeValue(entry.value, output.format));
      if (value !== undefined) outputs.push({ name: output.name, value });
      continue;
    }
    const elements: Element[] = [];
    for (let index = 0; index < list.length; index++) {
      const element: unknown = list[index];
      let target: Pick<Element, 'params' | 'identity'> | undefined;
      const value = take(`${title}, element ${index},`, () => {
        target = targetOf(element);
        return encodeValue(element, output.format);
      });
      if (value !== undefined) elements.push({ value, ...target!, index });
    }
    outputs.push({ name: output.name, elements });
  }
  return { outputs, faults: shorten(faults) };
}

function shorten(faults: ModuleFault[]): ModuleFault[] {
  if (faults.length <= MAX_FAULTS) return faults;
  const left = faults.length - MAX_FAULTS;
  const message = `${left} more values of this run are refused.`;
  return [...faults.slice(0, MAX_FAULTS), moduleFault('output', 'onProcessing', message)];
}

/** The list in `{ elements: […] }`, unless the value has the member of its format beside it. */
function elementsOf(value: unknown, format: DataFormat | undefined): unknown[] | undefined {
  if (typeof value !== 'object' || value === null || !('elements' in value)) return undefined;
  const { elements } = value;
  if (!Array.isArray(elements)) return undefined;
  const hasMember = format === undefined ? memberOf(value) !== undefined : format in value;
  return hasMember ? undefined : elements;
}

/** Where an element wants to go: `output_params` is what modules for Python write. [PM-46] [PM-48] */
function targetOf(element: unknown): Pick<Element, 'params' | 'identity'> {
  if (typeof element !== 'object' || element === null)
    return { params: undefined, identity: undefined };
  const { outputTopicParams, output_params, identity } = element as Record<string, unknown>;
  const params = outputTopicParams ?? output_params ?? undefined;
  if (params !== undefined && !Array.isArray(params)) {
    throw new Refused('its outputTopicParams must be an array.');
  }
  return {
    params: params?.map(parameterText),
    identity: identity === undefined || identity === null ? undefined : parameterText(identity),
  };
}

function parameterText(value: unknown): string {
  if (typeof value === 'string') return value;
  if (typeof value === 'number' || typeof value === 'boolean') return String(value);
  throw new Refused(`its parameters must be texts, got ${kindOf(value)}.`);
}

function encodeValue(source: unknown, format: DataFormat | undefined): SandboxValue {
  const wanted = format ?? 'a data format';
  if (typeof source !== 'object' || source === null) {
    throw new Refused(`expected an object with the member ${wanted}, got ${kindOf(source)}.`);
  }
  const member = format ?? memberOf(source);
  const value = member && (source as Record<string, unknown>)[member];
  if (member === undefined || value === undefined || value === null) {
    const members = Object.keys(source).slice(0, 5).join(', ');
    throw new Refused(
      `expected an object with the member ${wanted}, got ${members === '' ? 'an empty object' : `one with ${members}`}.`,
    );
  }
  const info: DataFormatInfo = DATA_FORMATS[member];
  const problem = info.validate(value);
  if (problem !== undefined) throw new Refused(problem);
  const timestamp = timestampOf((source as { timestamp?: unknown }).timestamp);
  const record: Record<string, unknown> = { timestamp, [member]: value };
  return {
    bytes: encode('ubii.topicData.TopicDataRecord', record as Init<TopicDataRecord>),
    valueField: info.fieldNumber,
    hasTimestamp: timestamp !== undefined,
  };
}

/** The one member that is a data format, for outputs of an unknown format. [PM-3] */
function memberOf(source: object): DataFormat | undefined {
  return Object.keys(source).find(isDataFormat);
}

/** A time stamp as the wire has it, or milliseconds since the epoch. [PM-32] */
function timestampOf(given: unknown): Init<Timestamp> | undefined {
  if (given === undefined || given === null) return undefined;
  if (typeof given === 'number' && Number.isFinite(given)) return timestampFromMs(given);
  if (typeof given !== 'object') throw new Refused('its timestamp must be an object with millis.');
  const stamp: Record<string, number> = {};
  for (const part of ['seconds', 'nanos', 'millis'] as const) {
    const number = (given as Record<string, unknown>)[part];
    if (number === undefined || number === null) continue;
    if (typeof number !== 'number' || !Number.isSafeInteger(Math.floor(number))) {
      throw new Refused(`the ${part} of its timestamp must be a number.`);
    }
    stamp[part] = Math.floor(number);
  }
  return stamp;
}

function kindOf(value: unknown): string {
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'an array';
  return typeof value === 'object' ? 'an object' : `a ${typeof value}`;
}
