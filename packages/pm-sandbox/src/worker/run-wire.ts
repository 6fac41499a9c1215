import type { ModuleFault } from '../ports/module-fault.ts';
import type {
  SandboxCall,
  SandboxInput,
  SandboxOutput,
  SandboxRecord,
  SandboxResult,
  SandboxValue,
} from '../ports/sandbox.ts';
import type { BytePacker } from './byte-packer.ts';

/**
 * Runs and their results are most of what travels. They are tuples: to clone an object with named
 * members takes twice as long, which is a tenth of a whole run.
 */
export type RunMessage = readonly [
  instance: number,
  call: number,
  deltaTimeMs: number,
  triggers: readonly string[] | 0,
  inputs: readonly WireInput[],
  masterTimeMs: number | undefined,
];

/** Name, and bytes (0: no record), or bytes, identities and times of arrival of the elements. */
type WireInput =
  | [name: string, record: Uint8Array | 0]
  | [
      name: string,
      records: Uint8Array[],
      identities: (string | undefined)[],
      receivedAtMs: (number | undefined)[],
    ];

/** The result of a run that ended well. */
export type ResultMessage = readonly [
  call: number,
  durationMs: number,
  faults: readonly ModuleFault[] | 0,
  outputs: readonly WireOutput[],
];

type WireOutput =
  | [name: string, bytes: Uint8Array, valueField: number, hasTimestamp: boolean]
  | [name: string, elements: readonly WireElement[]];

type WireElement = [
  bytes: Uint8Array,
  valueField: number,
  hasTimestamp: boolean,
  index: number,
  params: readonly string[] | undefined,
  identity: string | undefined,
];

/** Writes a run; its bytes are the packer's. */
export function wireRun(
  instance: number,
  call: number,
  { deltaTimeMs, inputs, triggers, masterTimeMs }: SandboxCall,
  packer: BytePacker,
): RunMessage {
  const wired = inputs.map((input) => wireInput(input, packer));
  return [instance, call, deltaTimeMs, triggers ?? 0, wired, masterTimeMs];
}

/** Reads a run. */
export function readRun([
  ,
  ,
  deltaTimeMs,
  triggers,
  inputs,
  masterTimeMs,
]: RunMessage): SandboxCall {
  return {
    deltaTimeMs,
    masterTimeMs,
    triggers: triggers === 0 ? undefined : triggers,
    inputs: inputs.map(readInput),
  };
}

/** Writes a result; its bytes are the packer's. */
export function wireResult(
  call: number,
  { durationMs, faults, outputs }: SandboxResult,
  packer: BytePacker,
): ResultMessage {
  const wired = outputs.map((output) => wireOutput(output, packer));
  return [call, durationMs, faults.length === 0 ? 0 : faults, wired];
}

/** Reads a result. */
export function readResult([, durationMs, faults, outputs]: ResultMessage): SandboxResult {
  return {
    durationMs,
    faults: faults === 0 ? [] : faults,
    outputs: outputs.map(readOutput),
  };
}

function wireInput(input: SandboxInput, packer: BytePacker): WireInput {
  if ('record' in input) {
    const wired: WireInput = [input.name, input.record?.bytes ?? 0];
    if (input.record !== undefined) packer.add(wired, 1, input.record.isOwned === true);
    return wired;
  }
  const records = input.elements.map(({ bytes }) => bytes);
  input.elements.forEach(({ isOwned }, i) => packer.add(records, i, isOwned === true));
  const identities = input.elements.map(({ identity }) => identity);
  return [input.name, records, identities, input.elements.map(({ receivedAtMs }) => receivedAtMs)];
}

function readInput(input: WireInput): SandboxInput {
  if (input.length === 4) {
    const [name, records, identities, times] = input;
    const elementOf = (bytes: Uint8Array, i: number): SandboxRecord => ({
      bytes,
      identity: identities[i],
      receivedAtMs: times[i],
    });
    return { name, elements: records.map(elementOf) };
  }
  const [name, bytes] = input;
  return { name, record: bytes === 0 ? undefined : { bytes } };
}

function wireOutput(output: SandboxOutput, packer: BytePacker): WireOutput {
  if ('value' in output) {
    const { bytes, valueField, hasTimestamp } = output.value;
    const wired: WireOutput = [output.name, bytes, valueField, hasTimestamp];
    packer.add(wired, 1, true);
    return wired;
  }
  const elements = output.elements.map(({ value, index, params, identity }) => {
    const { bytes, valueField, hasTimestamp } = value;
    const wired: WireElement = [bytes, valueField, hasTimestamp, index, params, identity];
    packer.add(wired, 0, true);
    return wired;
  });
  return [output.name, elements];
}

function readOutput(output: WireOutput): SandboxOutput {
  if (output.length === 4) {
    const [name, bytes, valueField, hasTimestamp] = output;
    return { name, value: { bytes, valueField, hasTimestamp } };
  }
  const [name, elements] = output;
  return {
    name,
    elements: elements.map(([bytes, valueField, hasTimestamp, index, params, identity]) => {
      const value: SandboxValue = { bytes, valueField, hasTimestamp };
      return { value, index, params, identity };
    }),
  };
}
