import { parseMode } from '@ubii/pm-sandbox';
import {
  DATA_FORMATS,
  fromJson,
  parseDataFormat,
  ProcessingModuleLanguage,
  type Init,
  type ModuleIO,
  type ProcessingMode,
  type ProcessingModule,
} from '@ubii/proto';
import { composeText, sourcesOf, splitText } from '../text/module-text.ts';

/** Input or output in the form. */
export interface IoDraft {
  readonly name: string;
  /** Short name of a data format, the module's own text for unknown formats, or empty for any. */
  readonly format: string;
  readonly isList: boolean;
  /** Of an input: its value while it has no record, as typed. [PM-5] */
  readonly defaultJson?: string | undefined;
  /** Meaning of its values, with unit and range. [PM-6] */
  readonly description?: string | undefined;
  /** Of a string input: the accepted texts. [PM-7] */
  readonly choices?: readonly string[] | undefined;
}

export type ModeKind = 'frequency' | 'trigger' | 'lockstep' | 'free';

/** Processing mode with the parameters of all kinds, so that switching between kinds loses none. */
export interface ModeDraft {
  readonly kind: ModeKind;
  readonly hertz: number;
  readonly minDelayMs: number;
  readonly allInputsNeedUpdate: boolean;
}

/** Module in the editor. Plain data, stored as JSON. */
export interface ModuleDraft {
  readonly name: string;
  readonly description: string;
  readonly tags: readonly string[];
  readonly authors: readonly string[];
  readonly version: string;
  readonly libraries: readonly string[];
  /** Names of required asset sets, available in `state.assets`. */
  readonly assets: readonly string[];
  /** Names of optional asset sets, loaded with `state.loadAssets`. */
  readonly optionalAssets: readonly string[];
  readonly inputs: readonly IoDraft[];
  readonly outputs: readonly IoDraft[];
  readonly mode: ModeDraft;
  /** Source of all callbacks, see module-text.ts. */
  readonly code: string;
}

const DEFAULT_HERTZ = 30;

function ioDraft(io: ModuleIO): IoDraft {
  const { internalName, messageFormat, isRecordList, defaultJson, description, choices } = io;
  return {
    name: internalName,
    format: parseDataFormat(messageFormat) ?? messageFormat,
    isList: isRecordList,
    ...(defaultJson !== '' && { defaultJson }),
    ...(description !== '' && { description }),
    ...(choices.length > 0 && { choices }),
  };
}

function modeDraft(mode: ProcessingMode | undefined): ModeDraft {
  const parsed = parseMode(mode);
  return {
    kind: parsed.kind,
    hertz: parsed.kind === 'frequency' ? parsed.hertz : DEFAULT_HERTZ,
    minDelayMs: parsed.kind === 'trigger' ? parsed.minDelayMs : 0,
    allInputsNeedUpdate: parsed.kind === 'trigger' && parsed.allInputsNeedUpdate,
  };
}

export function draftOf(module: ProcessingModule): ModuleDraft {
  return {
    name: module.name,
    description: module.description,
    tags: module.tags,
    authors: module.authors,
    version: module.extension?.version ?? '',
    libraries: module.extension?.libraries ?? [],
    assets: module.extension?.assets ?? [],
    optionalAssets: module.extension?.optionalAssets ?? [],
    inputs: module.inputs.map(ioDraft),
    outputs: module.outputs.map(ioDraft),
    mode: modeDraft(module.processingMode),
    code: composeText(module),
  };
}

function ioOf({
  name,
  format,
  isList,
  defaultJson,
  description = '',
  choices = [],
}: IoDraft): Init<ModuleIO> {
  const known = parseDataFormat(format);
  return {
    internalName: name,
    messageFormat: known ? DATA_FORMATS[known].messageType : format,
    isRecordList: isList,
    ...(defaultJson !== undefined && { defaultJson }),
    ...(description !== '' && { description }),
    ...(choices.length > 0 && { choices: [...choices] }),
  };
}

function modeOf({ kind, hertz, minDelayMs, allInputsNeedUpdate }: ModeDraft): Init<ProcessingMode> {
  switch (kind) {
    case 'frequency':
      return { frequency: { hertz } };
    case 'trigger':
      return { triggerOnInput: { minDelayMs, allInputsNeedUpdate } };
    case 'lockstep':
      return { lockstep: {} };
    case 'free':
      return { free: {} };
  }
}

/**
 * Converts a draft to a module.
 * @param text its code, when it is split already
 */
export function moduleOf(draft: ModuleDraft, text = splitText(draft.code)): ProcessingModule {
  const { name, description, tags, authors, version, libraries, assets, optionalAssets } = draft;
  const module: ProcessingModule = {
    ...fromJson('ubii.processing.ProcessingModule', {}),
    name: name.trim(),
    description,
    tags: [...tags],
    authors: [...authors],
    language: ProcessingModuleLanguage.JS,
    ...sourcesOf(text),
  };
  return fromInit(module, {
    inputs: draft.inputs.map(ioOf),
    outputs: draft.outputs.map(ioOf),
    processingMode: modeOf(draft.mode),
    extension: {
      version,
      libraries: [...libraries],
      assets: [...assets],
      optionalAssets: [...optionalAssets],
    },
  });
}

/** Sets the members without a field in the form. */
function fromInit(
  module: ProcessingModule,
  init: {
    readonly inputs: readonly Init<ModuleIO>[];
    readonly outputs: readonly Init<ModuleIO>[];
    readonly processingMode: Init<ProcessingMode>;
    readonly extension: {
      readonly version: string;
      readonly libraries: readonly string[];
      readonly assets: readonly string[];
      readonly optionalAssets: readonly string[];
    };
  },
): ProcessingModule {
  const { inputs, outputs, processingMode, extension } = fromJson(
    'ubii.processing.ProcessingModule',
    JSON.parse(JSON.stringify(init)),
  );
  return { ...module, inputs, outputs, processingMode, extension };
}

/** Whether two drafts are equivalent. */
export function isSameDraft(a: ModuleDraft, b: ModuleDraft): boolean {
  return draftKey(a) === draftKey(b);
}

/**
 * Key for comparison. Whitespace between callbacks and the order of members are ignored.
 * @param text its code, when it is split already
 */
export function draftKey(draft: ModuleDraft, text = splitText(draft.code)): string {
  const { code, name, inputs, outputs, ...rest } = draft;
  const isSound = text.problems.length === 0;
  const ios = [inputs.map(ioOf), outputs.map(ioOf)];
  return JSON.stringify([name.trim(), rest, ios, isSound ? sourcesOf(text) : code]);
}
