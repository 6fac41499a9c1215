import type { Session } from '@ubii/proto';

/** Input or output of a session's module that a path refers to. */
export interface ProblemPlace {
  readonly moduleId: string;
  readonly side: 'input' | 'output';
  /** Internal name of the input or output. */
  readonly name: string;
}

const MAPPING = /^ioMappings\[(\d+)\]\.(input|output)Mappings\[(\d+)\]/;
const DECLARED = /^processingModules\[(\d+)\]\.(input|output)s\[(\d+)\]/;

type Placed = Pick<Session, 'ioMappings' | 'processingModules' | 'extension'>;

/** Returns the input or output that a problem concerns; `undefined` when it concerns something else. */
export function placeOf(session: Placed, path: string): ProblemPlace | undefined {
  const [, mappingAt, mappingSide, entryAt] = MAPPING.exec(path) ?? [];
  if (mappingAt !== undefined) {
    const mapping = session.ioMappings[Number(mappingAt)];
    const at = Number(entryAt);
    const name =
      mappingSide === 'input'
        ? mapping?.inputMappings[at]?.inputName
        : mapping?.outputMappings[at]?.outputName;
    return place(mapping?.processingModuleId, mappingSide, name);
  }
  const [, moduleAt, side, ioAt] = DECLARED.exec(path) ?? [];
  const module = moduleAt === undefined ? undefined : session.processingModules[Number(moduleAt)];
  const list = side === 'input' ? module?.inputs : module?.outputs;
  return place(module?.id, side, list?.[Number(ioAt)]?.internalName);
}

function place(
  moduleId: string | undefined,
  side: string | undefined,
  name: string | undefined,
): ProblemPlace | undefined {
  if (moduleId === undefined || name === undefined) return undefined;
  return { moduleId, side: side === 'input' ? 'input' : 'output', name };
}
