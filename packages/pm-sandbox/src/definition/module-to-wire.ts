import {
  DATA_FORMATS,
  ProcessingModuleLanguage,
  type Init,
  type ModuleIO,
  type ProcessingMode,
  type ProcessingModule,
} from '@ubii/proto';
import { callbackSource } from './callback-source.ts';
import type { AnyModuleDefinition, ModeInit } from './define-processing-module.ts';
import type { IoInits } from './io-types.ts';

/**
 * The message that says what a module is, callbacks as source text. The callbacks must not use what
 * is outside of them. [PM-2]
 *
 * @throws TypeError when a callback is no function or has no source
 */
export function moduleToWire(definition: AnyModuleDefinition): Init<ProcessingModule> {
  const {
    onProcessing,
    onHalted,
    onDestroyed,
    libraries = [],
    assets = [],
    optionalAssets = [],
    version = '',
  } = definition;
  const source = (fn: unknown, name: string): string =>
    fn === undefined ? '' : callbackSource(fn, name);
  return {
    name: definition.name,
    description: definition.description ?? '',
    authors: [...(definition.authors ?? [])],
    tags: [...(definition.tags ?? [])],
    processingMode: definition.mode === undefined ? undefined : modeToWire(definition.mode),
    inputs: ioToWire(definition.inputs),
    outputs: ioToWire(definition.outputs),
    language: ProcessingModuleLanguage.JS,
    onCreatedStringified: createdSource(definition),
    onProcessingStringified: callbackSource(onProcessing, 'onProcessing'),
    onHaltedStringified: source(onHalted, 'onHalted'),
    onDestroyedStringified: source(onDestroyed, 'onDestroyed'),
    extension:
      version !== '' || libraries.length + assets.length + optionalAssets.length > 0
        ? { version, libraries, assets, optionalAssets }
        : undefined,
  };
}

/** Old nodes know no createState: it becomes the first thing onCreated does. */
function createdSource({ createState, onCreated }: AnyModuleDefinition): string {
  const created = onCreated === undefined ? '' : callbackSource(onCreated, 'onCreated');
  if (createState === undefined) return created;
  const first = `Object.assign(state, (${callbackSource(createState, 'createState')}\n)());`;
  const then = created === '' ? '' : `\nreturn (${created}\n)(state);`;
  return `(state) => { ${first}${then} }`;
}

function ioToWire(inits: IoInits): Init<ModuleIO>[] {
  return Object.entries(inits).map(([internalName, init]) => {
    const io = typeof init === 'string' ? { format: init } : init;
    const { format, list = false, default: value, description = '', choices = [] } = io;
    return {
      internalName,
      messageFormat: DATA_FORMATS[format].messageType,
      isRecordList: list,
      ...(value !== undefined && { defaultJson: JSON.stringify({ [format]: value }) }),
      ...(description !== '' && { description }),
      ...(choices.length > 0 && { choices: [...choices] }),
    };
  });
}

function modeToWire(mode: ModeInit): Init<ProcessingMode> {
  if ('frequency' in mode) return { frequency: mode.frequency };
  if ('lockstep' in mode) return { lockstep: {} };
  if ('free' in mode) return { free: {} };
  const { minDelayMs = 0, allInputsNeedUpdate = false } = mode.triggerOnInput;
  return { triggerOnInput: { minDelayMs, allInputsNeedUpdate } };
}
