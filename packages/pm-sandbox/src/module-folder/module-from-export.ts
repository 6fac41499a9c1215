import { decode, encode, fromJson, type Init, type ProcessingModule } from '@ubii/proto';
import type { AnyModuleDefinition } from '../definition/define-processing-module.ts';
import { moduleProblems } from '../definition/module-problems.ts';
import { moduleToWire } from '../definition/module-to-wire.ts';

const MODULE = 'ubii.processing.ProcessingModule';

/**
 * The module of an object: a definition with functions, or the members of a `ProcessingModule` with
 * source text or with functions.
 *
 * @throws Error with one sentence
 */
export function moduleFromExport(value: unknown): ProcessingModule {
  if (!isObject(value)) {
    throw new Error(
      `Expected a processing module, as an object with name and onProcessing, received ${describe(value)}`,
    );
  }
  return typeof value['onProcessing'] === 'function'
    ? checked(fromFunctions(value))
    : moduleFromJson(value);
}

/**
 * The module of a `.pm` file's content.
 *
 * @throws Error with one sentence
 */
export function moduleFromJson(json: unknown): ProcessingModule {
  const module = fromJson(MODULE, json);
  if (module.onProcessingStringified.trim() === '') {
    throw new Error('Expected onProcessing, or onProcessingStringified with its source text');
  }
  return checked(module);
}

/** Inputs and outputs are an object by name, or a list as in a message. */
function fromFunctions(value: Record<string, unknown>): ProcessingModule {
  const { inputs = {}, outputs = {}, processingMode } = value;
  const definition = {
    ...value,
    name: typeof value['name'] === 'string' ? value['name'] : '',
    inputs: Array.isArray(inputs) ? {} : inputs,
    outputs: Array.isArray(outputs) ? {} : outputs,
  };
  const init: Init<ProcessingModule> = moduleToWire(definition as unknown as AnyModuleDefinition);
  const listed = fromJson(MODULE, {
    ...(Array.isArray(inputs) ? { inputs: inputs as object[] } : {}),
    ...(Array.isArray(outputs) ? { outputs: outputs as object[] } : {}),
    ...(isObject(processingMode) ? { processingMode } : {}),
  });
  return decode(
    MODULE,
    encode(MODULE, {
      ...init,
      ...(Array.isArray(inputs) ? { inputs: listed.inputs } : {}),
      ...(Array.isArray(outputs) ? { outputs: listed.outputs } : {}),
      ...(listed.processingMode === undefined ? {} : { processingMode: listed.processingMode }),
    }),
  );
}

function checked(module: ProcessingModule): ProcessingModule {
  const problems = moduleProblems(module);
  if (problems.length === 0) return module;
  throw new Error(
    problems
      .map(({ path, message }) =>
        path === '' || path === 'name' ? message : `${path}: ${message}`,
      )
      .join(' '),
  );
}

function isObject(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}

function describe(value: unknown): string {
  if (value === undefined) return 'nothing: the file needs a default export';
  if (Array.isArray(value)) return 'a list';
  return typeof value === 'function' ? 'a function or class' : JSON.stringify(value);
}
