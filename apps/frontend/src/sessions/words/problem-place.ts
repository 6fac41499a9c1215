import type { Session, SessionProblem } from '@ubii/proto';

/** Which mapping of a session a path leads to. */
export interface ProblemPlace {
  /** Index among the mappings of modules. */
  readonly mapping: number;
  readonly side: 'input' | 'output';
  /** Index among the inputs or outputs that are mapped. */
  readonly index: number;
}

const PLACE = /^ioMappings\[(\d+)\]\.(input|output)Mappings\[(\d+)\]/;

/** The mapping a problem is about; `undefined` when it is about something else. */
export function placeOf(path: string): ProblemPlace | undefined {
  const [, mapping, side, index] = PLACE.exec(path) ?? [];
  if (mapping === undefined || index === undefined) return undefined;
  return {
    mapping: Number(mapping),
    side: side === 'input' ? 'input' : 'output',
    index: Number(index),
  };
}

/** What is wrong with one input or output of a module. */
export function problemsOf(
  session: Pick<Session, 'ioMappings' | 'extension'>,
  moduleId: string,
  side: ProblemPlace['side'],
  name: string,
): readonly SessionProblem[] {
  return (session.extension?.problems ?? []).filter(({ path }) => {
    const place = placeOf(path);
    const mapping = place && session.ioMappings[place.mapping];
    if (place?.side !== side || mapping?.processingModuleId !== moduleId) return false;
    const { inputMappings, outputMappings } = mapping;
    return side === 'input'
      ? inputMappings[place.index]?.inputName === name
      : outputMappings[place.index]?.outputName === name;
  });
}
