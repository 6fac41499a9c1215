import {
  moduleToWire,
  parseModule,
  type AnyModuleDefinition,
  type LoadedAssets,
  type SandboxEvents,
  type SandboxFactory,
  type SandboxInput,
  type SandboxOutput,
  type SandboxRecord,
  type SandboxValue,
} from '@ubii/pm-sandbox';
import { dataFormatOfField, decode, encode, type Init, type TopicDataRecord } from '@ubii/proto';
import { isList, outputValues, toRecord, type Drive, type DrivenModule } from './drive-module.ts';

const LIMITS = { callTimeoutMs: 500, memoryBytes: 2 ** 26, outputBytes: 2 ** 20 };
/** Sandboxes that share workers tell instances apart by their ids. */
const instances = { count: 0 };
const RECORD = 'ubii.topicData.TopicDataRecord';
const MODULE = 'ubii.processing.ProcessingModule';

/** Events of a driven instance for its test. */
export type DrivenEvents = Partial<Pick<SandboxEvents, 'onLog' | 'onLoadAssets'>>;

/**
 * The callbacks as text in a sandbox, records encoded on both ways.
 *
 * @param createSandboxes with libraries by name
 */
export function driveIn(
  createSandboxes: (libraries: { readonly [name: string]: unknown }) => SandboxFactory,
  isTrusted = true,
  assets: readonly LoadedAssets[] = [],
  events: DrivenEvents = {},
): Drive {
  return (definition, libraries = {}) =>
    drive(createSandboxes(libraries), definition, isTrusted, assets, events);
}

async function drive(
  sandboxes: SandboxFactory,
  definition: AnyModuleDefinition,
  isTrusted: boolean,
  assets: readonly LoadedAssets[],
  events: DrivenEvents,
): Promise<DrivenModule> {
  const { name, outputs, source, ...parsed } = parseModule(
    decode(MODULE, encode(MODULE, moduleToWire(definition))),
  );
  const sandbox = sandboxes.open(
    {
      instanceId: `instance-${++instances.count}`,
      moduleName: name,
      source: source!,
      isTrusted,
      libraries: parsed.libraries,
      assets,
      inputs: parsed.inputs.map(({ name }) => name),
      owner: '',
      outputs,
      limits: LIMITS,
    },
    // Pending calls reject with the same fault.
    { onLog: () => undefined, onKilled: () => undefined, ...events },
  );
  await sandbox.create();

  const inputs = new Map<string, SandboxInput>(
    parsed.inputs.map(({ name, isList }) => [
      name,
      isList ? { name, elements: [] } : { name, record: undefined },
    ]),
  );
  let records: { [name: string]: unknown } = {};
  return {
    get outputs() {
      return records;
    },
    async run(deltaTimeMs, values = {}, triggers) {
      for (const [name, value] of Object.entries(values)) {
        const init = definition.inputs[name];
        if (isList(init)) {
          const elements = (value as readonly unknown[]).map((e) =>
            encodeSample(toRecord(init, name, e)),
          );
          inputs.set(name, { name, elements });
        } else {
          const record =
            value === undefined ? undefined : encodeSample(toRecord(init, name, value));
          inputs.set(name, { name, record });
        }
      }
      const result = await sandbox.run({ deltaTimeMs, inputs: [...inputs.values()], triggers });
      if (result.faults[0] !== undefined) throw new Error(result.faults[0].message);
      records = Object.fromEntries(
        result.outputs.map((output) => [output.name, decodeOutput(output)]),
      );
      return outputValues(definition, records);
    },
  };
}

function encodeSample(record: { [member: string]: unknown }): SandboxRecord {
  const { identity, type: _, ...members } = record;
  return {
    bytes: encode(RECORD, members as Init<TopicDataRecord>),
    identity: identity as string | undefined,
  };
}

function decodeOutput(output: SandboxOutput): unknown {
  if ('value' in output) return decodeValue(output.value);
  return {
    elements: output.elements.map(({ value, params }) => ({
      ...(decodeValue(value) as object),
      outputTopicParams: params,
    })),
  };
}

function decodeValue({ bytes, valueField }: SandboxValue): unknown {
  const record = decode(RECORD, bytes) as unknown as { [member: string]: unknown };
  const member = dataFormatOfField(valueField)!;
  const { timestamp } = record;
  return { [member]: record[member], ...(timestamp === undefined ? {} : { timestamp }) };
}
