import { runInNewContext } from 'node:vm';
import { moduleToWire, type AnyModuleDefinition, type IoInit } from '@ubii/pm-sandbox';
import type { DataFormat } from '@ubii/proto';

/** Values of inputs by name; of a list, its elements. Members other than the value are the record's. */
export type InputValues = { readonly [name: string]: unknown };

/** One instance, run by hand. */
export interface DrivenModule {
  /**
   * One run. Inputs keep what they were given before; undefined takes the record away.
   *
   * @param triggers as with the mode trigger-on-input; undefined as with any other
   * @returns the values of the outputs by name; of lists, the elements
   */
  run(
    deltaTimeMs: number,
    inputs?: InputValues,
    triggers?: readonly string[],
  ): Promise<{ [name: string]: unknown }>;
  /** Unmodified outputs of the newest run. */
  readonly outputs: { readonly [name: string]: unknown };
}

/** Runs an instance. */
export type Drive = (
  definition: AnyModuleDefinition,
  libraries?: { readonly [name: string]: unknown },
) => Promise<DrivenModule>;

/** A value that comes with other members of its record: timestamp, topic, identity, another format. */
export class Sample {
  readonly value: unknown;
  readonly members: { readonly [member: string]: unknown };

  constructor(value: unknown, members: { readonly [member: string]: unknown }) {
    this.value = value;
    this.members = members;
  }
}

interface Callbacks {
  createState?(): object;
  onCreated?(state: object): unknown;
  onProcessing(deltaTimeMs: number, inputs: object, state: object): unknown;
}

/** The callbacks as they were written. */
export const driveDirectly: Drive = (definition, libraries) =>
  drive(definition, definition, libraries);

/** The callbacks as text, where there is nothing but the language and a console. */
export const driveStringified: Drive = (definition, libraries) => {
  const wire = moduleToWire(definition);
  const evaluate = (source: string | null | undefined): unknown =>
    source ? runInNewContext(`(${source}\n)`, { console }) : undefined;
  return drive(
    definition,
    {
      onCreated: evaluate(wire.onCreatedStringified) as Callbacks['onCreated'],
      onProcessing: evaluate(wire.onProcessingStringified) as Callbacks['onProcessing'],
    },
    libraries,
  );
};

async function drive(
  definition: AnyModuleDefinition,
  callbacks: Callbacks,
  libraries: { readonly [name: string]: unknown } = {},
): Promise<DrivenModule> {
  let state: { [member: string]: unknown } = { modules: libraries };
  Object.assign(state, callbacks.createState?.());
  await callbacks.onCreated?.(state);
  const inputs = emptyInputs(definition);
  let outputs: { [name: string]: unknown } = {};
  return {
    get outputs() {
      return outputs;
    },
    async run(deltaTimeMs, values = {}, triggers) {
      for (const [name, value] of Object.entries(values)) {
        inputs[name] = inputRecord(definition, name, value);
      }
      state.inputTriggerNames = triggers;
      const result = (await callbacks.onProcessing(deltaTimeMs, { ...inputs }, state)) as
        | { outputs?: { [name: string]: unknown }; state?: { [member: string]: unknown } }
        | undefined;
      if (result?.state !== undefined) state = result.state;
      // Out of the other context, as it would cross a boundary.
      outputs = ownCopy(result?.outputs ?? {}) as typeof outputs;
      return outputValues(definition, outputs);
    },
  };
}

/** A copy without what is undefined, made here whatever context the value is from. */
function ownCopy(value: unknown): unknown {
  if (ArrayBuffer.isView(value)) return new Uint8Array(value as Uint8Array);
  if (Array.isArray(value)) return value.map(ownCopy);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(
    Object.entries(value)
      .filter(([, member]) => member !== undefined)
      .map(([name, member]) => [name, ownCopy(member)]),
  );
}

/** An input before anything came. */
export function emptyInputs(definition: AnyModuleDefinition): { [name: string]: unknown } {
  const inputs = Object.entries(definition.inputs as { [name: string]: IoInit });
  return Object.fromEntries(
    inputs.map(([name, init]) => [name, isList(init) ? { elements: [] } : undefined]),
  );
}

function inputRecord(definition: AnyModuleDefinition, name: string, value: unknown): unknown {
  const init = (definition.inputs as { [name: string]: IoInit })[name];
  if (init === undefined) throw new Error(`${definition.name} has no input ${name}`);
  if (!isList(init)) return value === undefined ? undefined : toRecord(init, name, value);
  return { elements: (value as readonly unknown[]).map((e) => toRecord(init, name, e)) };
}

/** A record as a module sees it. [PM-30] */
export function toRecord(
  init: IoInit,
  name: string,
  value: unknown,
): { [member: string]: unknown } {
  const sample = value instanceof Sample ? value : new Sample(value, {});
  const type = (sample.members.type as DataFormat | undefined) ?? formatOf(init);
  const members = { topic: `/${name}`, timestamp: undefined, clientId: '', type };
  return { ...members, ...sample.members, [type]: sample.value };
}

/** The values in what a module put out. */
export function outputValues(
  definition: AnyModuleDefinition,
  outputs: { readonly [name: string]: unknown },
): { [name: string]: unknown } {
  const inits = definition.outputs as { [name: string]: IoInit };
  const values: { [name: string]: unknown } = {};
  for (const [name, output] of Object.entries(outputs)) {
    const init = inits[name];
    if (init === undefined) throw new Error(`${definition.name} has no output ${name}`);
    const record = output as { readonly [member: string]: unknown };
    values[name] = isList(init) ? record.elements : record[formatOf(init)];
  }
  return values;
}

export function formatOf(init: IoInit): DataFormat {
  return typeof init === 'string' ? init : init.format;
}

export function isList(init: IoInit): boolean {
  return typeof init !== 'string' && init.list === true;
}
