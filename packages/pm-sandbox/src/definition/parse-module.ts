import {
  parseDataFormat,
  type DataFormat,
  type ModuleIO,
  type ProcessingMode,
  type ProcessingModule,
} from '@ubii/proto';
import { DEFAULT_RUNTIME_LIMITS } from '../limits.ts';
import type { ModuleSource } from '../ports/sandbox.ts';

/** Runs a second of a module that does not say. [PM-20] */
const DEFAULT_FREQUENCY_HZ = 30;

/** An input or output as it was understood. */
export interface ParsedIo {
  readonly name: string;
  /** Undefined: unknown, so an input takes any record. [PM-3] */
  readonly format: DataFormat | undefined;
  /** Data format as the module wrote it. */
  readonly formatText: string;
  readonly isList: boolean;
  /** Of an input: its value while it has no record, as JSON of one record member; empty: none. [PM-5] */
  readonly defaultJson: string;
}

/** When a module runs, numbers within their limits. [PM-20] */
export type ParsedMode =
  | { readonly kind: 'frequency'; readonly hertz: number }
  | {
      readonly kind: 'trigger';
      /** Milliseconds, 0 or more. */
      readonly minDelayMs: number;
      readonly allInputsNeedUpdate: boolean;
    }
  | { readonly kind: 'lockstep' }
  | { readonly kind: 'free' };

/** A module as it was understood. */
export interface ParsedModule {
  readonly name: string;
  readonly inputs: readonly ParsedIo[];
  readonly outputs: readonly ParsedIo[];
  readonly mode: ParsedMode;
  /** Undefined when it comes without code. */
  readonly source: ModuleSource | undefined;
  readonly libraries: readonly string[];
  readonly assets: readonly string[];
  readonly optionalAssets: readonly string[];
  /** Empty when the author gave none. */
  readonly version: string;
}

/** Understands a module leniently; `moduleProblems` says what is wrong with it. Never throws. */
export function parseModule(module: ProcessingModule): ParsedModule {
  return {
    name: module.name,
    inputs: module.inputs.map(parseIo),
    outputs: module.outputs.map(parseIo),
    mode: parseMode(module.processingMode),
    source: parseSource(module),
    libraries: module.extension?.libraries ?? [],
    assets: module.extension?.assets ?? [],
    optionalAssets: module.extension?.optionalAssets ?? [],
    version: module.extension?.version ?? '',
  };
}

/** Understands a processing mode: no mode, and no sensible frequency, is 30 Hz. [PM-20] */
export function parseMode(
  mode: ProcessingMode | undefined,
  maxFrequencyHz = DEFAULT_RUNTIME_LIMITS.maxFrequencyHz,
): ParsedMode {
  if (mode?.triggerOnInput !== undefined) {
    const { minDelayMs, allInputsNeedUpdate } = mode.triggerOnInput;
    return { kind: 'trigger', minDelayMs: minDelayMs > 0 ? minDelayMs : 0, allInputsNeedUpdate };
  }
  if (mode?.lockstep !== undefined) return { kind: 'lockstep' };
  if (mode?.free !== undefined) return { kind: 'free' };
  const hertz = mode?.frequency?.hertz ?? 0;
  return {
    kind: 'frequency',
    hertz: hertz > 0 ? Math.min(hertz, maxFrequencyHz) : DEFAULT_FREQUENCY_HZ,
  };
}

function parseIo(io: ModuleIO): ParsedIo {
  return {
    name: io.internalName,
    format: parseDataFormat(io.messageFormat),
    formatText: io.messageFormat,
    isList: io.isRecordList,
    defaultJson: io.defaultJson,
  };
}

function parseSource(module: ProcessingModule): ModuleSource | undefined {
  const given = (text: string): string | undefined => (text.trim() === '' ? undefined : text);
  const onProcessing = given(module.onProcessingStringified);
  if (onProcessing === undefined) return undefined;
  return {
    onProcessing,
    onCreated: given(module.onCreatedStringified),
    onHalted: given(module.onHaltedStringified),
    onDestroyed: given(module.onDestroyedStringified),
  };
}
