import type { IOMapping, Session, TopicDemux, TopicMux } from '@ubii/proto';
import { endKey, readModules } from './read-mappings.ts';

/**
 * Adds missing ids to modules, muxers and demuxers, as a master does [SE-2]. Required before editing: without ids,
 * moved and removed elements could not be distinguished.
 * @param uuid returns a new UUID
 * @returns the session itself when nothing lacks an id
 */
export function withIds(session: Session, uuid: () => string): Session {
  const modules = readModules(session);
  const mappings = [...session.ioMappings];
  const taken = new Set<string>();
  const processingModules = modules.map(({ module, mappingIndex }) => {
    const id = module.id === '' || taken.has(module.id) ? uuid() : module.id;
    taken.add(id);
    const mapping = mappings[mappingIndex];
    if (mapping !== undefined && mapping.processingModuleId !== id) {
      mappings[mappingIndex] = { ...mapping, processingModuleId: id };
    }
    return id === module.id ? module : { ...module, id };
  });
  const idOf = spreaderIds(uuid);
  const ioMappings = mappings.map((mapping) => withSpreaderIds(mapping, idOf));
  const isSame =
    processingModules.every((module, index) => module === session.processingModules[index]) &&
    ioMappings.every((mapping, index) => mapping === session.ioMappings[index]);
  return isSame ? session : { ...session, processingModules, ioMappings };
}

type IdOf = (spreader: TopicMux | TopicDemux, key: string) => string;

/** Muxers or demuxers with the same id share it only if their content is equal; others get a new id. */
function spreaderIds(uuid: () => string): IdOf {
  const keys = new Map<string, string>();
  const given = new Map<string, string>();
  return ({ id }, key) => {
    if (id === '') return uuid();
    const known = keys.get(id);
    if (known === undefined) keys.set(id, key);
    if (known === undefined || known === key) return id;
    const other = given.get(key) ?? uuid();
    given.set(key, other);
    return other;
  };
}

function withSpreaderIds(mapping: IOMapping, idOf: IdOf): IOMapping {
  let isSame = true;
  const inputMappings = mapping.inputMappings.map((one) => {
    const { topicMux: mux } = one;
    const id = mux && idOf(mux, endKey({ kind: 'muxer', mux }));
    if (mux === undefined || id === undefined || id === mux.id) return one;
    isSame = false;
    return { ...one, topicMux: { ...mux, id } };
  });
  const outputMappings = mapping.outputMappings.map((one) => {
    const { topicDemux: demux } = one;
    const id = demux && idOf(demux, endKey({ kind: 'demuxer', demux }));
    if (demux === undefined || id === undefined || id === demux.id) return one;
    isSame = false;
    return { ...one, topicDemux: { ...demux, id } };
  });
  return isSame ? mapping : { ...mapping, inputMappings, outputMappings };
}
