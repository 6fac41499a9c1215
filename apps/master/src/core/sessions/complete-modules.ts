import { hasSameCode } from '@ubii/pm-sandbox';
import {
  isUuid,
  ModuleOrigin,
  type IOMapping,
  type ModuleIO,
  type ProcessingModule,
  type Session,
  type SessionProblem,
} from '@ubii/proto';
import { withOrigin } from '../library/module-library.ts';
import type { ModuleOffer } from '../library/module-offer.ts';
import { errorProblem } from './problems.ts';
import { quote } from '../texts/quote.ts';

/** One module of a request with its mapping, complete. */
export interface DraftModule {
  /** Complete [SE-1], but for the node that the master will choose. */
  spec: ProcessingModule;
  /** Its one mapping [SE-2]. */
  mapping: IOMapping;
  /** The node that the session names; undefined when the master chooses. */
  requestedNodeId: string | undefined;
  /** Path in the request, such as `processingModules[0]`. */
  readonly path: string;
  /** Path of its mapping in the request; the path it would have if there is none. */
  mappingPath: string;
  /** The source is from the library, so that it needs no check [PM-64]. */
  isLibraryCode: boolean;
}

/** Dependencies for completing a specification. */
export interface CompletionContext {
  uuid(): string;
  /** Another session has a module of this id. */
  isTaken(moduleId: string): boolean;
  /** Returns the node of this module in the session to be replaced, if it has one. */
  placed?(
    moduleId: string,
  ): { readonly nodeId: string; readonly requestedNodeId: string | undefined } | undefined;
  /** Id of the node that a request names, `master` for this master [SE-30]; undefined for an empty text. */
  nodeId(text: string): string | undefined;
  /** The module of this name as the library has it. */
  stored(name: string): ModuleOffer | undefined;
  /** The module of this name as a node offers it; of any node without an id. */
  offered(name: string, nodeId: string | undefined): ProcessingModule | undefined;
}

/** Modules and mappings of a request, each complete and with its ids [SE-1] [SE-2]. */
export function completeModules(
  message: Session,
  context: CompletionContext,
): { modules: DraftModule[]; problems: SessionProblem[] } {
  const modules: DraftModule[] = [];
  const taken = new Set<string>();
  const byGivenId = new Map<string, DraftModule>();
  message.processingModules.forEach((given, index) => {
    const draft = completeModule(given, index, context);
    const isFree = isUuid(given.id) && !taken.has(given.id) && !context.isTaken(given.id);
    draft.spec.id = isFree ? given.id : context.uuid();
    taken.add(draft.spec.id);
    if (given.id !== '' && !byGivenId.has(given.id)) byGivenId.set(given.id, draft);
    modules.push(draft);
  });
  const problems = assignMappings(message.ioMappings, modules, byGivenId);
  for (const { spec, mapping } of modules) {
    mapping.processingModuleId = spec.id;
    mapping.processingModuleName = spec.name;
    nameMultiplexers(mapping, context);
  }
  return { modules, problems };
}

function completeModule(
  given: ProcessingModule,
  index: number,
  context: CompletionContext,
): DraftModule {
  const requestedNodeId = requestedNode(given, context);
  const stored = context.stored(given.name);
  const offered = context.offered(given.name, requestedNodeId);
  // A node's own description takes precedence; without a node, the stored module, which users see in the list.
  const base =
    requestedNodeId === undefined ? (stored?.module ?? offered) : (offered ?? stored?.module);
  const merged = mergeModules(given, base);
  const origin = originOf(merged, stored, offered);
  const spec = (merged.extension?.origin ?? 0) === origin ? merged : withOrigin(merged, origin);
  const isLibraryCode =
    stored !== undefined && stored.isTrusted && hasSameCode(spec, stored.module);
  return {
    spec: { ...spec, nodeId: requestedNodeId ?? '' },
    mapping: emptyMapping(),
    requestedNodeId,
    path: `processingModules[${index}]`,
    mappingPath: `ioMappings[${index}]`,
    isLibraryCode,
  };
}

/** Where the code that runs is from: own code has the name of another module, or says so itself, at will. [SE-22] */
function originOf(
  spec: ProcessingModule,
  stored: ModuleOffer | undefined,
  offered: ProcessingModule | undefined,
): ModuleOrigin {
  if (stored !== undefined && hasSameCode(spec, stored.module)) {
    const { isTrusted, module } = stored;
    return isTrusted ? (module.extension?.origin ?? 0) : ModuleOrigin.MODULE_ORIGIN_STORED;
  }
  const isOffered = offered !== undefined && hasSameCode(spec, offered);
  return isOffered ? ModuleOrigin.MODULE_ORIGIN_NODE : ModuleOrigin.MODULE_ORIGIN_UNKNOWN;
}

/** A client that sends back a session does not request the node that the master chose [SE-30]. */
function requestedNode(given: ProcessingModule, context: CompletionContext): string | undefined {
  const nodeId = context.nodeId(given.nodeId);
  const placed = context.placed?.(given.id);
  const isSentBack = given.extension?.replaceable ?? placed !== undefined;
  if (placed === undefined) return isSentBack ? undefined : nodeId;
  return isSentBack && nodeId === placed.nodeId ? placed.requestedNodeId : nodeId;
}

/** Merges a module of a request with its base; members of the request take precedence. */
function mergeModules(
  given: ProcessingModule,
  base: ProcessingModule | undefined,
): ProcessingModule {
  if (base === undefined) return { ...given };
  const code = given.onProcessingStringified === '' ? base : given;
  return {
    ...given,
    authors: given.authors.length > 0 ? given.authors : base.authors,
    tags: given.tags.length > 0 ? given.tags : base.tags,
    description: given.description || base.description,
    processingMode: hasMode(given) ? given.processingMode : base.processingMode,
    inputs: given.inputs.length > 0 ? withOffered(given.inputs, base.inputs) : base.inputs,
    outputs: given.outputs.length > 0 ? withOffered(given.outputs, base.outputs) : base.outputs,
    language: given.language || base.language,
    onProcessingStringified: code.onProcessingStringified,
    onCreatedStringified: code.onCreatedStringified,
    onHaltedStringified: code.onHaltedStringified,
    onDestroyedStringified: code.onDestroyedStringified,
    extension: given.extension ?? base.extension,
  };
}

/** Default, description and choices come from the offer of the module [PM-5] [PM-6] [PM-7]. */
function withOffered(given: readonly ModuleIO[], base: readonly ModuleIO[]): ModuleIO[] {
  return given.map((io) => {
    const offered = base.find(({ internalName }) => internalName === io.internalName);
    if (offered?.messageFormat !== io.messageFormat) return io;
    return {
      ...io,
      defaultJson: io.defaultJson || offered.defaultJson,
      description: io.description || offered.description,
      choices: io.choices.length > 0 ? io.choices : offered.choices,
    };
  });
}

/** Mappings go to the module of their id, else to those of their name, in order [SE-2]. */
function assignMappings(
  mappings: readonly IOMapping[],
  modules: readonly DraftModule[],
  byGivenId: ReadonlyMap<string, DraftModule>,
): SessionProblem[] {
  const problems: SessionProblem[] = [];
  const assigned = new Set<DraftModule>();
  const byName = mappings.map((mapping, index) => ({ mapping, path: `ioMappings[${index}]` }));
  const assign = (draft: DraftModule, mapping: IOMapping, path: string): void => {
    if (!assigned.has(draft)) {
      draft.mapping = copyMapping(mapping);
      draft.mappingPath = path;
    } else {
      draft.mapping.inputMappings.push(...mapping.inputMappings);
      draft.mapping.outputMappings.push(...mapping.outputMappings);
    }
    assigned.add(draft);
  };
  const rest = byName.filter(({ mapping, path }) => {
    const draft = byGivenId.get(mapping.processingModuleId);
    if (draft !== undefined) assign(draft, mapping, path);
    return draft === undefined;
  });
  for (const { mapping, path } of rest) {
    const named = modules.filter(({ spec }) => spec.name === mapping.processingModuleName);
    const draft =
      named.find((one) => !assigned.has(one)) ?? (named.length === 1 ? named[0] : undefined);
    if (draft !== undefined) assign(draft, mapping, path);
    else problems.push(strayMapping(mapping, path));
  }
  return problems;
}

function strayMapping(mapping: IOMapping, path: string): SessionProblem {
  const { processingModuleId: moduleId, processingModuleName: moduleName } = mapping;
  const wanted = moduleName === '' ? `the id ${quote(moduleId)}` : `the name ${quote(moduleName)}`;
  return errorProblem({
    code: 'mapping_without_module',
    message: `The mapping is for a module with ${wanted}, but no such module of the session is without a mapping. Add the module, or remove the mapping.`,
    path,
    moduleId,
    moduleName,
  });
}

/** Existing nodes refuse muxers without an id. */
function nameMultiplexers(mapping: IOMapping, { uuid }: CompletionContext): void {
  for (const input of mapping.inputMappings) {
    if (input.topicMux !== undefined) {
      input.topicMux = { ...input.topicMux, id: input.topicMux.id || uuid() };
    }
  }
  for (const output of mapping.outputMappings) {
    if (output.topicDemux !== undefined) {
      output.topicDemux = { ...output.topicDemux, id: output.topicDemux.id || uuid() };
    }
  }
}

/** The request stays as it is: what is changed here is a copy. */
function copyMapping(mapping: IOMapping): IOMapping {
  return {
    ...mapping,
    inputMappings: mapping.inputMappings.map((input) => ({ ...input })),
    outputMappings: mapping.outputMappings.map((output) => ({ ...output })),
  };
}

function emptyMapping(): IOMapping {
  return {
    processingModuleId: '',
    processingModuleName: '',
    inputMappings: [],
    outputMappings: [],
  };
}

function hasMode({ processingMode }: ProcessingModule): boolean {
  if (processingMode === undefined) return false;
  const { frequency, lockstep, triggerOnInput, free } = processingMode;
  return (frequency ?? lockstep ?? triggerOnInput ?? free) !== undefined;
}
