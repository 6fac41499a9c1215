import * as v from 'valibot';
import { compileMapping } from './compile-mapping.ts';
import { faultOf, MappingFault } from './mapping-fault.ts';
import type { Mapping, Protocol } from './mapping.ts';
import { WRITTEN_MAPPINGS } from './written-mapping.ts';
import type { WrittenMapping } from './written-mapping.ts';

/** Most problems that are returned for one list. */
const MAX_PROBLEMS = 200;

/** What is wrong with one of several mappings, and where. */
export interface MappingProblem {
  readonly index: number;
  /** Member of the mapping; empty for the mapping as a whole. */
  readonly member: string;
  /** One sentence for a view that shows the member. */
  readonly message: string;
  /** One sentence with the place: `mappings[2].qos must be 0, 1 or 2, but is 3.` */
  readonly sentence: string;
}

/** Mappings of a list, and what is wrong with it. */
export interface ReadMappings {
  readonly problems: readonly MappingProblem[];
  /** In the order of the list; `undefined` for one that is wrong. */
  readonly mappings: readonly (Mapping | undefined)[];
  /** Those that are switched off, by index. */
  readonly disabled: ReadonlySet<number>;
}

/** Reads a list of mappings as they are written. A file and a page are checked by this. [BR-1] [BR-81] */
export function findMappingProblems(list: readonly unknown[], protocol: Protocol): ReadMappings {
  const problems: MappingProblem[] = [];
  const names = new Set<string>();
  const disabled = new Set<number>();
  const mappings = list.map((written, index) => {
    const add = ({ member, words, message }: MappingFault): void => {
      if (problems.length >= MAX_PROBLEMS) return;
      const sentence = `mappings[${index}]${message}`;
      problems.push({ index, member, message: words, sentence });
    };
    const mapping = readMapping(written, protocol, add);
    if ((written as WrittenMapping | null)?.enabled === false) disabled.add(index);
    if (mapping === undefined) return undefined;
    const { name } = mapping;
    if (!names.has(name)) {
      names.add(name);
      return mapping;
    }
    const taken = `"${name}" is the name of another mapping. Choose another one.`;
    return void add(new MappingFault('name', taken));
  });
  return { problems, mappings, disabled };
}

function readMapping(
  written: unknown,
  protocol: Protocol,
  add: (fault: MappingFault) => void,
): Mapping | undefined {
  const result = v.safeParse(WRITTEN_MAPPINGS[protocol], written, { abortPipeEarly: true });
  if (!result.success) {
    for (const issue of result.issues) add(faultOf(issue));
    return undefined;
  }
  try {
    return compileMapping(result.output as WrittenMapping, protocol);
  } catch (error) {
    if (!(error instanceof MappingFault)) throw error;
    add(error);
    return undefined;
  }
}
