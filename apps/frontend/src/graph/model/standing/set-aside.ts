import { isSameValue, toJson, type JsonObject, type JsonValue, type Session } from '@ubii/proto';
import type { IOMapping, ProcessingModule, TopicInputMapping } from '@ubii/proto';
import * as v from 'valibot';
import { storedValue } from '../../../json/read-stored.ts';
import { message } from '../../../json/schemas.ts';
import type { Standing } from '../graph.ts';

/** Input with a replaced mapping while a module is bypassed. */
export interface Detour {
  readonly moduleId: string;
  readonly was: TopicInputMapping;
  readonly now: TopicInputMapping;
}

/** Bypassed or muted module, stored in the editor data only. Old clients do not see it. */
export interface SetAside {
  readonly standing: Exclude<Standing, 'active'>;
  readonly module: ProcessingModule;
  readonly mapping: IOMapping | undefined;
  /** Original positions in the lists of the session. */
  readonly moduleIndex: number;
  readonly mappingIndex: number;
}

/** All bypassed and muted modules of a session. */
export interface Aside {
  readonly modules: readonly SetAside[];
  readonly detours: readonly Detour[];
}

export const NOTHING_ASIDE: Aside = { modules: [], detours: [] };

/** Returns the session with all modules enabled. */
export function restored(session: Session, { modules, detours }: Aside): Session {
  const taken = new Set(session.processingModules.map(({ id }) => id));
  const back = modules.filter(({ module: { id } }) => {
    const isFree = id !== '' && !taken.has(id);
    taken.add(id);
    return isFree;
  });
  if (back.length === 0) return session;
  const processingModules = [...session.processingModules];
  const ioMappings = session.ioMappings.map((mapping) => withoutDetours(mapping, detours));
  for (const { module, moduleIndex } of sortedBy(back, 'moduleIndex')) {
    processingModules.splice(moduleIndex, 0, module);
  }
  for (const { mapping, mappingIndex } of sortedBy(back, 'mappingIndex')) {
    if (mapping !== undefined) ioMappings.splice(mappingIndex, 0, mapping);
  }
  return { ...session, processingModules, ioMappings };
}

const sortedBy = (list: readonly SetAside[], key: 'moduleIndex' | 'mappingIndex'): SetAside[] =>
  [...list].sort((a, b) => a[key] - b[key]);

function withoutDetours(mapping: IOMapping, detours: readonly Detour[]): IOMapping {
  const own = detours.filter(({ moduleId }) => moduleId === mapping.processingModuleId);
  if (own.length === 0) return mapping;
  return {
    ...mapping,
    // Keep mappings that were changed in the meantime.
    inputMappings: mapping.inputMappings.map(
      (one) => own.find(({ now }) => isSameValue(now, one))?.was ?? one,
    ),
  };
}

/** Returns the session without the modules, and with the detours. */
export function setAside(session: Session, { modules, detours }: Aside): Session {
  if (modules.length === 0) return session;
  const resting = new Set(modules.map(({ module }) => module));
  const mappings = new Set(modules.map(({ mapping }) => mapping));
  return {
    ...session,
    processingModules: session.processingModules.filter((module) => !resting.has(module)),
    ioMappings: session.ioMappings
      .filter((mapping) => !mappings.has(mapping))
      .map((mapping) => {
        const own = detours.filter(({ moduleId }) => moduleId === mapping.processingModuleId);
        if (own.length === 0) return mapping;
        const inputMappings = mapping.inputMappings.map(
          (one) => own.find(({ was }) => was === one)?.now ?? one,
        );
        return { ...mapping, inputMappings };
      }),
  };
}

const MODULE = 'ubii.processing.ProcessingModule';
const MAPPING = 'ubii.sessions.IOMapping';
const INPUT = 'ubii.sessions.TopicInputMapping';

/** JSON for the editor data; undefined without modules. */
export function asideJson({ modules, detours }: Aside): JsonObject | undefined {
  if (modules.length === 0) return undefined;
  return {
    modules: modules.map(({ standing, module, mapping, moduleIndex, mappingIndex }) => ({
      standing,
      module: toJson(MODULE, module),
      mapping: mapping === undefined ? null : toJson(MAPPING, mapping),
      moduleIndex,
      mappingIndex,
    })),
    detours: detours.map(({ moduleId, was, now }) => ({
      moduleId,
      was: toJson(INPUT, was),
      now: toJson(INPUT, now),
    })),
  };
}

const index = v.pipe(v.number(), v.integer(), v.minValue(0));

const ASIDE = v.object({
  modules: v.array(
    v.pipe(
      v.object({
        standing: v.picklist(['bypassed', 'muted']),
        module: message(MODULE),
        mapping: v.nullable(message(MAPPING)),
        moduleIndex: index,
        mappingIndex: index,
      }),
      v.transform(({ mapping, ...rest }): SetAside => ({ ...rest, mapping: mapping ?? undefined })),
    ),
  ),
  detours: v.array(v.object({ moduleId: v.string(), was: message(INPUT), now: message(INPUT) })),
});

/** Returns undefined for unknown JSON. */
export const readAside = (json: JsonValue | undefined): Aside | undefined =>
  storedValue(ASIDE, json);
