import type { Init, ProcessingModule, Session } from '@ubii/proto';
import { copiedEditorData } from './copied-editor-data.ts';

/**
 * The parts of a session that users specify, without those that the master adds: status, problems, and nodes chosen by
 * the master.
 */
export function sessionSpec(session: Session): Init<Session> {
  const { name, description, tags, authors, editable, ioMappings, extension } = session;
  return {
    name,
    description,
    tags,
    authors,
    editable,
    processingModules: session.processingModules.map(moduleSpec),
    ioMappings,
    extension: {
      startWithMaster: extension?.startWithMaster ?? false,
      lockstepHertz: extension?.lockstepHertz ?? 0,
      editorJson: extension?.editorJson ?? '',
    },
  };
}

/** The parts of a module that users specify. */
export function moduleSpec(module: ProcessingModule): Init<ProcessingModule> {
  const { sessionId: _session, status: _status, nodeId, extension, ...rest } = module;
  return {
    ...rest,
    nodeId: extension?.replaceable === true ? '' : nodeId,
    extension: {
      version: extension?.version ?? '',
      libraries: extension?.libraries ?? [],
      assets: extension?.assets ?? [],
      optionalAssets: extension?.optionalAssets ?? [],
    },
  };
}

/**
 * Returns a copy of a session; modules get new ids, and mappings refer to them.
 * @param uuid returns a new UUID
 */
export function sessionCopy(spec: Init<Session>, uuid: () => string): Init<Session> {
  const ids = new Map<string, string>();
  const processingModules = (spec.processingModules ?? []).map((module) => {
    const id = uuid();
    if (module.id) ids.set(module.id, id);
    return { ...module, id };
  });
  const ioMappings = (spec.ioMappings ?? []).map((mapping) => ({
    ...mapping,
    processingModuleId:
      ids.get(mapping.processingModuleId ?? '') ?? mapping.processingModuleId ?? '',
  }));
  const editorJson = copiedEditorData(spec.extension?.editorJson ?? '', ids, uuid);
  const extension = editorJson === '' ? spec.extension : { ...spec.extension, editorJson };
  return { ...spec, id: '', processingModules, ioMappings, extension };
}

/** Removes the node assignments of modules, because nodes differ between installations. */
export function withoutPlaces(spec: Init<Session>): Init<Session> {
  const modules = spec.processingModules ?? [];
  return { ...spec, processingModules: modules.map((module) => ({ ...module, nodeId: '' })) };
}

/** `Name copy`, `Name copy 2`, …: the first that is free. */
export function copyName(name: string, taken: ReadonlySet<string>): string {
  const base = name.replace(/ copy(?: \d+)?$/, '');
  for (let number = 1; ; number += 1) {
    const candidate = `${base} copy${number === 1 ? '' : ` ${number}`}`;
    if (!taken.has(candidate)) return candidate;
  }
}

/** The name itself, or with the first number that makes it unique: `Name 2`. */
export function freeName(name: string, taken: ReadonlySet<string>): string {
  if (!taken.has(name)) return name;
  for (let number = 2; ; number += 1) {
    const candidate = `${name} ${number}`;
    if (!taken.has(candidate)) return candidate;
  }
}
